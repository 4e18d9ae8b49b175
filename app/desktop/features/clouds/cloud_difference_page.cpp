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
#include "look/pixels.h"
#include "look/scrolled_page.h"
#include "views/figure_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int histogram_px = 190;                   // high
constexpr double histogram_height_to_width = 0.66;  // of one that is exported

}  // namespace

render::DistanceBars distance_bars(const CloudDistances& distances, bool of_height) {
  using Of = render::DistanceBars::Of;
  const auto& histogram = of_height ? distances.found.rises : distances.found.distances;
  render::DistanceBars bars;
  bars.of = of_height ? Of::height : distances.options.to_plane ? Of::surface : Of::nearest_point;
  bars.lo_m = histogram.lo_m;
  bars.bin_m = histogram.bin_m;
  bars.counts = histogram.counts;
  bars.compared = histogram.compared;
  bars.below = histogram.below;
  bars.above = histogram.above;
  bars.unmatched = histogram.unmatched;
  bars.within_m = distances.options.max_m;
  bars.median_m = histogram.median_m;
  bars.lo95_m = histogram.lo95_m;
  bars.hi95_m = histogram.hi95_m;
  return bars;
}

QString histogram_name(const CloudEntry& cloud, bool of_height) {
  return (of_height ? Clouds::tr("Height differences of %1") : Clouds::tr("Distances of %1")).arg(cloud.name());
}

// What is exported is English.
std::vector<OfferedFigure> distance_figures(const std::vector<CloudEntry>& clouds) {
  std::vector<OfferedFigure> figures;
  for (const auto& cloud : clouds) {
    if (!cloud.distances) continue;
    for (const bool of_height : {false, true}) {
      auto bars = distance_bars(*cloud.distances, of_height);
      bars.cloud = cloud.name().toStdString();
      bars.from = cloud.distances->from == 0 ? "the survey" : cloud.distances->from_name.toStdString();
      figures.push_back({histogram_name(cloud, of_height), [bars](double width_mm) {
                           return render::distance_histogram(bars, {width_mm, histogram_height_to_width * width_mm});
                         }});
    }
  }
  return figures;
}

CloudDifferencePage::CloudDifferencePage(Clouds& clouds, Workbench& bench)
    : clouds_(clouds),
      from_(new QComboBox),
      show_(new QComboBox),
      surface_(new QCheckBox(tr("From the surface"))),
      said_(new QLabel),
      histogram_(new FigureView({}, this)),
      export_(new QToolButton) {
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
  show_->addItem(tr("by distance (unsigned)"), QString::fromStdString(distance_column));
  show_->addItem(tr("by height difference (signed)"), QString::fromStdString(rise_column));
  show_->setToolTip(tr("A height difference is positive where the cloud is higher"));
  up_to_ = cloud_number("cloud_distance_up_to", tr("The last colour stands for this and more"),
                        {0.001, 1000, 0.05, 3, tr(" m")});
  for (auto* box : {from_, show_}) box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  look->addRow(tr("Colour"), show_);
  look->addRow(tr("Colours up to"), up_to_);
  column->addLayout(look);
  histogram_->setObjectName("cloud_histogram");
  histogram_->setFixedHeight(histogram_px);
  column->addWidget(histogram_);
  put_action(*export_, *bench.commands().action("clouds.export_histogram"), tr("Export histogram…"));
  column->addWidget(export_, 0, Qt::AlignLeft);
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
  show_->setEnabled(distances != nullptr);
  up_to_->setEnabled(colored);
  said_->setText(distances ? words_of(*distances)
                           : tr("Measured for the places that the clouds have; moving one of them ends it."));
  if (colored) {
    following_ = true;
    up_to_->setValue(cloud->color_range_m);
    show_->setCurrentIndex(cloud->color_by == rise_column ? 1 : 0);
    following_ = false;
  }
  show_histogram(distances.get());
  if (distances && distances != shown_) scroll_to(*histogram_);
  shown_ = distances;
}

bool CloudDifferencePage::of_height() const { return show_->currentData().toString().toStdString() == rise_column; }

void CloudDifferencePage::show_histogram(const CloudDistances* distances) {
  histogram_->setVisible(distances != nullptr);
  export_->setVisible(distances != nullptr);
  if (distances == nullptr) return histogram_->show_figure({});
  histogram_->show_figure([bars = distance_bars(*distances, of_height())](double width_mm) {
    return render::distance_histogram(bars, {width_mm, histogram_px * mm_per_px});
  });
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
  show_histogram(cloud->distances.get());
  if (cloud->read->on_disk()) return;  // its points have no such colours
  const double up_to_m = typed(*up_to_, cloud->color_range_m);
  const auto column = show_->currentData().toString().toStdString();
  if (cloud->color_by != column) clouds_.paint(cloud_, cloud->color, column, cloud->point_px);
  clouds_.color_up_to(cloud_, up_to_m);
}

}  // namespace bole::desktop
