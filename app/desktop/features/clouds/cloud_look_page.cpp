#include "features/clouds/cloud_look_page.h"

#include <QColorDialog>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "features/clouds/cloud_file.h"
#include "features/clouds/cloud_widgets.h"
#include "features/clouds/clouds.h"
#include "look/array_words.h"

namespace bole::desktop {
namespace {

constexpr double max_size_px = 12;
const QString one_color;  // in place of an array

QString color_title(const std::string& array) {
  if (array == "z") return CloudLookPage::tr("Height (z)");
  if (array == distance_column) return CloudLookPage::tr("Distance");
  if (array == rise_column) return CloudLookPage::tr("Height difference");
  return array_words(array);
}

}  // namespace

CloudLookPage::CloudLookPage(Clouds& clouds)
    : clouds_(clouds),
      color_by_(new QComboBox),
      color_(new QToolButton),
      opacity_(new QSlider(Qt::Horizontal)),
      percent_(new QLabel) {
  color_by_->setObjectName("cloud_color_by");
  color_by_->setToolTip(tr("One colour keeps clouds apart. Numbers that colour the survey too have the same scale."));
  color_by_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(color_by_, QOverload<int>::of(&QComboBox::activated), this, &CloudLookPage::take);
  color_->setObjectName("cloud_color");
  color_->setToolTip(tr("Another colour for the cloud"));
  color_->setFocusPolicy(Qt::StrongFocus);
  connect(color_, &QToolButton::clicked, this, &CloudLookPage::choose_color);
  auto* form = new QFormLayout(this);
  auto* colors = new QHBoxLayout;
  colors->addWidget(color_by_, 1);
  colors->addWidget(color_);
  form->addRow(tr("Colour"), colors);
  size_ = cloud_number("cloud_size", tr("Size of a point on the screen"), {0, max_size_px, 1, 0, tr(" px")});
  size_->setSpecialValueText(tr("as the survey"));
  connect(size_, number_changed, this, &CloudLookPage::take);
  form->addRow(tr("Point size"), size_);
  form->addRow(tr("Opacity"), make_opacity());
}

QWidget* CloudLookPage::make_opacity() {
  opacity_->setObjectName("cloud_opacity");
  opacity_->setRange(static_cast<int>(std::lround(100 * min_opacity)), 100);
  opacity_->setPageStep(10);
  opacity_->setToolTip(tr("How little shines through the points of the cloud in the 3-D view"));
  percent_->setMinimumWidth(percent_->fontMetrics().horizontalAdvance("100 %"));
  percent_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  connect(opacity_, &QSlider::valueChanged, this, &CloudLookPage::take_opacity);
  connect(opacity_, &QSlider::sliderReleased, this, &CloudLookPage::take_opacity);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(opacity_, 1);
  layout->addWidget(percent_);
  return row;
}

void CloudLookPage::follow(const CloudEntry* cloud) {
  setEnabled(cloud != nullptr);
  cloud_ = cloud == nullptr ? 0 : cloud->id;
  if (cloud == nullptr) return;
  following_ = true;
  size_->setValue(cloud->point_px);
  const int percent = static_cast<int>(std::lround(100 * cloud->opacity));
  opacity_->setValue(percent);
  percent_->setText(tr("%1 %").arg(percent));
  show_colors(*cloud);
  following_ = false;
}

void CloudLookPage::show_colors(const CloudEntry& cloud) {
  color_by_->clear();
  color_by_->addItem(tr("One colour"), one_color);
  if (cloud.read)
    for (const auto& array : render::paintable_arrays(*cloud.read->points))
      color_by_->addItem(color_title(array), QString::fromStdString(array));
  color_by_->setCurrentIndex(std::max(0, color_by_->findData(QString::fromStdString(cloud.color_by))));
  color_->setIcon(swatch(qt_color(cloud.color)));
  color_->setEnabled(cloud.color_by.empty());
}

void CloudLookPage::take() {
  const auto* cloud = clouds_.find(cloud_);
  if (following_ || cloud == nullptr) return;
  clouds_.paint(cloud_, cloud->color, color_by_->currentData().toString().toStdString(), size_->value());
}

// While the slider is held nothing is written.
void CloudLookPage::take_opacity() {
  if (!following_) clouds_.fade(cloud_, opacity_->value() / 100.0, !opacity_->isSliderDown());
}

void CloudLookPage::choose_color() {
  const auto* cloud = clouds_.find(cloud_);
  if (cloud == nullptr) return;
  const int id = cloud->id;
  const QColor chosen = QColorDialog::getColor(qt_color(cloud->color), this, tr("Colour of the cloud"));
  cloud = clouds_.find(id);  // a document may have been opened meanwhile
  if (!chosen.isValid() || cloud == nullptr) return;
  clouds_.paint(id, render::hex(chosen.rgb() & 0xffffffU), cloud->color_by, cloud->point_px);
}

}  // namespace bole::desktop
