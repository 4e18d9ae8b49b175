#include "features/clouds/cloud_difference_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "features/clouds/cloud_align_page.h"
#include "features/clouds/cloud_widgets.h"
#include "features/clouds/clouds.h"
#include "workbench/workbench.h"

namespace bole::desktop {

CloudDifferencePage::CloudDifferencePage(Clouds& clouds, Workbench& bench)
    : clouds_(clouds),
      from_(new QComboBox),
      show_(new QComboBox),
      surface_(new QCheckBox(tr("From the surface"))),
      said_(new QLabel) {
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  from_->setObjectName("cloud_distance_from");
  from_->setToolTip(tr("What the distances are measured from"));
  within_ =
      cloud_number("cloud_distance_within", tr("Points with nothing nearer than this are counted apart, and grey"),
                   {0.01, 1000, 1, 2, tr(" m")});
  within_->setValue(alignment::DifferenceOptions().max_m);
  surface_->setObjectName("cloud_distance_surface");
  surface_->setToolTip(
      tr("From the plane through the points about the nearest one, so that the distance between the "
         "points of the other cloud counts less"));
  form->addRow(tr("From"), from_);
  form->addRow(tr("Look within"), within_);
  form->addRow(surface_);
  column->addLayout(form);
  auto* measure = new QToolButton;
  put_action(*measure, *bench.commands().action("clouds.measure_distances"), tr("Measure distances"));
  auto* save = new QToolButton;
  put_action(*save, *bench.commands().action("clouds.save"), tr("Save…"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(measure);
  buttons->addWidget(save);
  buttons->addStretch();
  column->addLayout(buttons);
  said_->setObjectName("cloud_distance_said");
  said_->setWordWrap(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(said_);
  auto* look = new QFormLayout;
  show_->setObjectName("cloud_distance_show");
  show_->addItem(tr("by distance"), QString::fromStdString(distance_column));
  show_->addItem(tr("by height difference"), QString::fromStdString(rise_column));
  show_->setToolTip(tr("A height difference is positive where the cloud is higher"));
  up_to_ = cloud_number("cloud_distance_up_to", tr("The last colour stands for this and more"),
                        {0.001, 1000, 0.05, 3, tr(" m")});
  for (auto* box : {from_, show_}) box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  look->addRow(tr("Colour"), show_);
  look->addRow(tr("Colours up to"), up_to_);
  column->addLayout(look);
  column->addStretch(1);
  connect(show_, QOverload<int>::of(&QComboBox::activated), this, &CloudDifferencePage::take_look);
  connect(up_to_, number_changed, this, &CloudDifferencePage::take_look);
}

int CloudDifferencePage::from() const { return from_->currentData().toInt(); }

alignment::DifferenceOptions CloudDifferencePage::options() const {
  return {.max_m = within_->value(), .to_plane = surface_->isChecked()};
}

void CloudDifferencePage::follow(const CloudEntry* cloud) {
  setEnabled(cloud != nullptr);
  cloud_ = cloud == nullptr ? 0 : cloud->id;
  list_partners(*from_, clouds_, cloud_);
  const auto distances = cloud == nullptr ? nullptr : cloud->distances;
  const bool colored = distances && !cloud->read->on_disk();
  for (auto* widget : {static_cast<QWidget*>(show_), static_cast<QWidget*>(up_to_)}) widget->setEnabled(colored);
  said_->setText(distances ? words_of(*distances)
                           : tr("Measured for the places that the clouds have; moving one of them ends it."));
  if (!distances) return;
  following_ = true;
  up_to_->setValue(cloud->color_range_m);
  show_->setCurrentIndex(cloud->color_by == rise_column ? 1 : 0);
  following_ = false;
}

QString CloudDifferencePage::words_of(const CloudDistances& distances) const {
  const auto& found = distances.found;
  const double max_m = distances.options.max_m;
  const auto metres = [max_m](double m) {
    return std::isfinite(m) ? tr("%1 m").arg(m, 0, 'f', 3) : tr("more than %1 m").arg(max_m, 0, 'f', 2);
  };
  const auto count = [](std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); };
  QStringList lines;
  lines << (distances.options.to_plane ? tr("From the surface of %1, %2 points:") : tr("From %1, %2 points:"))
               .arg(distances.from_name, count(found.compared));
  lines << tr("median %1, 95 % below %2, maximum %3")
               .arg(metres(found.median_m), metres(found.p95_m), metres(found.largest_m));
  if (found.beyond > 0)
    lines << tr("%1 points (%2 %) have nothing within %3 m.")
                 .arg(count(found.beyond))
                 .arg(100.0 * static_cast<double>(found.beyond) / static_cast<double>(found.compared), 0, 'f', 1)
                 .arg(max_m, 0, 'f', 2);
  return lines.join('\n');
}

void CloudDifferencePage::take_look() {
  const auto* cloud = clouds_.find(cloud_);
  if (following_ || cloud == nullptr || !cloud->distances) return;
  const double up_to_m = typed(*up_to_, cloud->color_range_m);
  const auto column = show_->currentData().toString().toStdString();
  if (cloud->color_by != column) clouds_.paint(cloud_, cloud->color, column, cloud->point_px);
  clouds_.color_up_to(cloud_, up_to_m);
}

}  // namespace bole::desktop
