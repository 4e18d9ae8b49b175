#include "features/clouds/cloud_place_page.h"

#include <QFormLayout>
#include <QLabel>

#include "features/clouds/cloud_widgets.h"
#include "features/clouds/clouds.h"

namespace bole::desktop {
CloudPlacePage::CloudPlacePage(Clouds& clouds) : clouds_(clouds), scale_said_(new QLabel) {
  const QString degrees = QStringLiteral("°");
  const CloudNumber metres{-1e8, 1e8, 0.1, 3, tr(" m")}, angle{-360, 360, 0.5, 3, degrees},
      factor{min_scale, max_scale, 0.001, 5};
  auto* form = new QFormLayout(this);
  const QString titles[] = {tr("Shift x"), tr("Shift y"), tr("Shift z")};
  const char* ids[] = {"cloud_x", "cloud_y", "cloud_z"};
  for (std::size_t k = 0; k < 3; ++k) {
    shift_[k] = cloud_number(ids[k], tr("By how much the cloud is moved; its file stays as it is"), metres);
    form->addRow(titles[k], shift_[k]);
  }
  turn_ = cloud_number("cloud_turn", tr("Counter-clockwise about the vertical through the middle of the cloud"), angle);
  tilt_x_ =
      cloud_number("cloud_tilt_x", tr("About the x axis through the middle of the cloud: what is north rises"), angle);
  tilt_y_ =
      cloud_number("cloud_tilt_y", tr("About the y axis through the middle of the cloud: what is east sinks"), angle);
  scale_ = cloud_number("cloud_scale", tr("How much larger the cloud is shown than its file has it"), factor);
  form->addRow(tr("Turn"), turn_);
  form->addRow(tr("Tilt x"), tilt_x_);
  form->addRow(tr("Tilt y"), tilt_y_);
  form->addRow(tr("Scale"), scale_);
  scale_said_->setObjectName("cloud_scale_said");
  scale_said_->setWordWrap(true);
  form->addRow(scale_said_);
  for (auto* box : {shift_[0], shift_[1], shift_[2], turn_, tilt_x_, tilt_y_, scale_})
    connect(box, number_changed, this, &CloudPlacePage::take);
}

void CloudPlacePage::follow(const CloudEntry* cloud) {
  setEnabled(cloud != nullptr);
  cloud_ = cloud == nullptr ? 0 : cloud->id;
  const CloudPlacing at = cloud == nullptr ? CloudPlacing() : cloud->at;
  following_ = true;
  for (int k = 0; k < 3; ++k) shift_[static_cast<std::size_t>(k)]->setValue(at.shift_m[k]);
  turn_->setValue(at.turn_deg);
  tilt_x_->setValue(at.tilt_x_deg);
  tilt_y_->setValue(at.tilt_y_deg);
  scale_->setValue(at.scale);
  scale_said_->setText(
      "<b>" +
      tr("Not to scale: what is measured in this cloud is %1 times as large as in its file.").arg(at.scale, 0, 'g', 6) +
      "</b>");
  scale_said_->setVisible(at.scale != 1);
  following_ = false;
}

void CloudPlacePage::take() {
  const auto* cloud = clouds_.find(cloud_);
  if (following_ || cloud == nullptr) return;
  CloudPlacing at;
  for (int k = 0; k < 3; ++k) at.shift_m[k] = typed(*shift_[static_cast<std::size_t>(k)], cloud->at.shift_m[k]);
  at.turn_deg = typed(*turn_, cloud->at.turn_deg);
  at.tilt_x_deg = typed(*tilt_x_, cloud->at.tilt_x_deg);
  at.tilt_y_deg = typed(*tilt_y_, cloud->at.tilt_y_deg);
  at.scale = typed(*scale_, cloud->at.scale);
  clouds_.place(cloud_, at);
}

}  // namespace bole::desktop
