// Runs: the commands to start and end them, their progress in the status bar, the dock of all jobs, and the curve of a
// training while it goes on.
#include <QDockWidget>
#include <QProgressBar>
#include <QStatusBar>

#include "features/run/jobs_panel.h"
#include "render/charts/plant_charts.h"
#include "views/figure_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int progress_steps = 1000, progress_width_px = 320;

void make_progress(Workbench* b) {
  auto* bar = new QProgressBar(b);
  bar->setMaximumWidth(progress_width_px);
  bar->setRange(0, progress_steps);
  bar->hide();
  b->statusBar()->addPermanentWidget(bar);
  QObject::connect(&b->runner(), &Runner::progressed, bar,
                   [b, bar](const QString& stage, double fraction, const QString& what) {
                     bar->setValue(static_cast<int>(progress_steps * fraction));
                     b->hint(stage + ": " + what);
                   });
  QObject::connect(&b->runner(), &Runner::jobs_changed, bar, [b, bar] { bar->setVisible(b->runner().running()); });
}

void make_run_commands(Workbench* b) {
  auto& commands = b->commands();
  commands.add({.id = "run.all",
                .text = Workbench::tr("Run"),
                .key = Qt::Key_F5,
                .places = {in_menu(Menu::run), in_tool_bar("run_bar")},
                .act = [b] { b->run(); },
                .enabled_when = b->with_document()});
  commands.add({.id = "run.without_files",
                .text = Workbench::tr("Run without writing files"),
                .key = QKeySequence("Shift+F5"),
                .places = {in_menu(Menu::run)},
                .act = [b] { b->run_without_files(); },
                .enabled_when = b->with_document()});
  commands.add({.id = "run.finish",
                .text = Workbench::tr("Keep result"),
                .places = {in_menu(Menu::run), in_tool_bar("run_bar")},
                .act = [b] { b->runner().finish(); },
                .enabled_when = b->with_run()});
  commands.add({.id = "run.cancel",
                .text = Workbench::tr("Cancel"),
                .places = {in_menu(Menu::run), in_tool_bar("run_bar")},
                .act = [b] { b->runner().cancel(); },
                .enabled_when = b->with_run()});
}

// The dock comes up with the first curve of a document.
void make_training(Workbench* b) {
  auto* view = new FigureView(Workbench::tr("While a field is trained its curve is shown here."), b);
  view->setObjectName("training_curve");
  b->docks().add("training", Workbench::tr("Training"), view, Qt::BottomDockWidgetArea, "stems");
  b->docks().find("training")->hide();
  QObject::connect(b, &Workbench::document_opened, view, [view] { view->show_figure({}); });
  QObject::connect(&b->runner(), &Runner::snapshot_taken, view, [b, view](const QString&, const DataSet& part) {
    if (!part.has("training")) return;
    if (view->empty()) b->docks().raise("training");
    view->show_figure(
        [table = part.get<Table>("training")](double width_mm) { return render::training_chart(*table, width_mm); });
  });
}

}  // namespace

void install_run(Workbench& bench) {
  make_run_commands(&bench);
  make_progress(&bench);
  bench.docks().add("jobs", Workbench::tr("Jobs"), new JobsPanel(bench.runner(), &bench), Qt::BottomDockWidgetArea,
                    "stems");
  make_training(&bench);
  bench.docks().raise("stems");
}

}  // namespace bole::desktop
