#include "features/history/compare_window.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "features/history/camera_link.h"
#include "render/charts/trajectory_charts.h"
#include "views/figure_view.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

QString shown_number(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) && size < 1e9) return QString::number(value, 'f', 0);
  return QString::number(value, 'f', size >= 100 ? 1 : size >= 1 ? 2 : 4);
}

QString shown_number(const std::optional<double>& value) { return value ? shown_number(*value) : QString(); }

}  // namespace

CompareWindow::CompareWindow(Side first, Side second, QWidget* parent)
    : QWidget(parent, Qt::Window),
      sides_{std::move(first), std::move(second)},
      table_(new QTableWidget(this)),
      all_numbers_(new QCheckBox(tr("All numbers"), this)) {
  setWindowTitle(tr("Runs %1 and %2 - Bole").arg(sides_[0].job->id).arg(sides_[1].job->id));
  resize(1400, 900);
  auto* views = new QSplitter(Qt::Horizontal, this);
  views->addWidget(column(0));
  views->addWidget(column(1));
  link_ = new CameraLink(*scenes_[0], *scenes_[1], this);
  auto* linked = new QCheckBox(tr("Cameras linked"), this);
  linked->setChecked(true);
  connect(linked, &QCheckBox::toggled, link_, &CameraLink::set_linked);
  connect(all_numbers_, &QCheckBox::toggled, this, &CompareWindow::fill_table);
  auto* line = new QHBoxLayout;
  line->addWidget(linked);
  line->addWidget(all_numbers_);
  line->addStretch();
  auto* below = new QWidget(this);
  auto* below_layout = new QVBoxLayout(below);
  below_layout->setContentsMargins(6, 2, 6, 6);
  below_layout->addLayout(line);
  below_layout->addWidget(table_);
  auto* all = new QSplitter(Qt::Vertical, this);
  all->addWidget(views);
  all->addWidget(below);
  all->setSizes({660, 240});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(all);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  fill_table();
}

QString CompareWindow::title(std::size_t which) const {
  const auto& job = *sides_[which].job;
  const auto changes = changed_options(*sides_[1 - which].job->document, *job.document);
  const QString what = changes.empty() ? job.title : changes_text(changes);
  return tr("Run %1: %2").arg(job.id).arg(what);
}

// Both charts have the same axis, else the worse run looks like the better one.
double CompareWindow::greatest_error() const {
  double max_error_cm = 0;
  for (const auto& side : sides_) {
    const auto reference = reference_path(*side.job->document, side.result.results);
    const auto& walk = side.result.survey.walk;
    if (!reference || !walk) continue;
    try {
      max_error_cm = std::max(max_error_cm, render::greatest_error_cm({walk.get(), reference.get(), nullptr}));
    } catch (const Error&) {  // a path of one pose: its chart says so
    }
  }
  return max_error_cm;
}

QWidget* CompareWindow::column(std::size_t which) {
  auto* box = new QWidget(this);
  auto* heading = new QLabel(title(which), box);
  heading->setMargin(4);
  heading->setToolTip(heading->text());
  heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  scenes_[which] = new SceneView(selections_[which], box);
  errors_[which] = new FigureView(tr("No reference path: give the file of one to see the error along the path."), box);
  const auto& side = sides_[which];
  const auto reference = reference_path(*side.job->document, side.result.results);
  if (reference && side.result.survey.walk)
    errors_[which]->show_figure(
        [reference, walk = side.result.survey.walk, top_cm = greatest_error()](double width_mm) {
          // The figure is drawn later: it must own both paths.
          auto figure = render::trajectory_error_chart({walk.get(), reference.get(), nullptr}, width_mm, top_cm);
          figure.draw = [reference, walk, draw = std::move(figure.draw)](render::Canvas& canvas) { draw(canvas); };
          return figure;
        });
  auto* parts = new QSplitter(Qt::Vertical, box);
  parts->addWidget(scenes_[which]);
  parts->addWidget(errors_[which]);
  parts->setSizes({460, 200});
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(heading);
  layout->addWidget(parts, 1);
  return box;
}

// The views want to be there before they are filled, for the camera depends on their shape.
void CompareWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (std::exchange(filled_, true)) return;
  const auto origin = [&](std::size_t which) {
    const auto& points = sides_[which].result.survey.points;
    return points ? points->origin : Eigen::Vector3d::Zero().eval();
  };
  link_->set_origins(origin(0), origin(1));
  for (std::size_t i = 2; i-- > 0;) scenes_[i]->show_survey(sides_[i].result.survey);
}

void CompareWindow::fill_table() {
  table_->setColumnCount(6);
  table_->setHorizontalHeaderLabels({tr("Stage"), tr("Number"), tr("Run %1").arg(sides_[0].job->id),
                                     tr("Run %1").arg(sides_[1].job->id), tr("Difference"), tr("Unit")});
  table_->setRowCount(0);
  const auto add = [&](const QStringList& texts) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int c = 0; c < texts.size(); ++c) {
      auto* item = new QTableWidgetItem(texts[c]);
      if (c >= 2 && c <= 4) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, c, item);
    }
  };
  const auto text = [](const std::string& s) { return QString::fromStdString(s); };
  for (const auto& c : changed_options(*sides_[0].job->document, *sides_[1].job->document))
    add({text(c.stage), text(c.option), text(c.before), text(c.after), tr("option"), {}});
  for (const auto& n : compared_numbers(sides_[0].result.outcome, sides_[1].result.outcome)) {
    if (!n.main && !all_numbers_->isChecked()) continue;
    QString difference;
    if (n.first && n.second) {
      difference = shown_number(*n.second - *n.first);
      if (*n.second > *n.first) difference.prepend('+');
    }
    add({n.stage, n.name, shown_number(n.first), shown_number(n.second), difference, n.unit});
  }
  table_->resizeColumnsToContents();
}

}  // namespace bole::desktop
