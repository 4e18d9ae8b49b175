#include "main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolBar>
#include <utility>

#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "views/scene_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

// The last output of a kind that a stage made under one of these ports.
template <class T>
std::shared_ptr<const T> latest(const RunOutcome& outcome, const Results& results, const std::string& port) {
  for (auto stage = outcome.stages.rbegin(); stage != outcome.stages.rend(); ++stage) {
    const auto found = results.find(stage->record.id);
    if (found == results.end() || !found->second.has(port)) continue;
    if (const auto* p = std::get_if<std::shared_ptr<const T>>(&found->second.all().find(port)->second)) return *p;
  }
  return nullptr;
}

StageState panel_state(const StageOutcome& stage) {
  switch (stage.state) {
    case bole::StageState::done:
    case bole::StageState::from_cache:
      return stage.record.report.warnings.empty() ? StageState::done : StageState::warning;
    case bole::StageState::failed:
      return StageState::failed;
    default:
      return StageState::idle;
  }
}

}  // namespace

MainWindow::MainWindow()
    : run_(new RunBehavior(session_, this)),
      edit_(new EditBehavior(session_, this)),
      pipeline_(new PipelinePanel(session_, this)),
      properties_(new PropertiesPanel(session_, this)),
      scene_(new SceneView(this)),
      slice_(new SliceView(this)),
      stems_(new TablePanel(this)),
      log_(new QPlainTextEdit(this)),
      progress_(new QProgressBar(this)) {
  setWindowTitle(tr("Bole"));
  resize(1600, 1000);
  setAcceptDrops(true);
  setCentralWidget(scene_);
  log_->setReadOnly(true);
  progress_->setMaximumWidth(320);
  progress_->hide();
  statusBar()->addPermanentWidget(progress_);
  make_docks();
  make_actions();
  connect(pipeline_, &PipelinePanel::stage_selected, properties_, &PropertiesPanel::show_stage);
  connect(properties_, &PropertiesPanel::refused, this, &MainWindow::say);
  connect(run_, &RunBehavior::progressed, this, [this](const QString& stage, double fraction, const QString& what) {
    pipeline_->set_state(stage, StageState::running);
    progress_->setValue(static_cast<int>(1000 * fraction));
    statusBar()->showMessage(stage + ": " + what);
  });
  connect(run_, &RunBehavior::finished, this, &MainWindow::show_outcome);
  connect(stems_, &TablePanel::tree_selected, scene_, &SceneView::highlight_tree);
  connect(stems_, &TablePanel::tree_selected, slice_, &SliceView::show_tree);
  connect(stems_, &TablePanel::edit_requested, this,
          [this](const StemEdit& edit) { guarded([&] { edit_->apply(edit); }); });
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    // An edit of a stem, made, undone or redone, is seen at once; other options wait for Run.
    if (session_.document().at(stage.toStdString()).type->name == "stems.edit" && scene_->has_survey())
      guarded([&] { refresh(); });
  });
}

void MainWindow::make_docks() {
  const auto dock = [this](const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* d = new QDockWidget(title, this);
    d->setObjectName(title);
    d->setWidget(widget);
    addDockWidget(area, d);
  };
  dock(tr("Pipeline"), pipeline_, Qt::LeftDockWidgetArea);
  dock(tr("Options"), properties_, Qt::LeftDockWidgetArea);
  dock(tr("Stems"), stems_, Qt::BottomDockWidgetArea);
  dock(tr("Slice"), slice_, Qt::BottomDockWidgetArea);
  dock(tr("Log"), log_, Qt::BottomDockWidgetArea);
}

void MainWindow::make_actions() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(
      tr("Open pipeline…"), this,
      [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Open pipeline"), {}, tr("Pipelines (*.json)"));
        if (!path.isEmpty()) guarded([&] { open(path); });
      },
      QKeySequence::Open);
  file->addAction(
      tr("Save pipeline"), this,
      [this] {
        guarded([&] {
          if (session_.has_document()) save(session_.path());
        });
      },
      QKeySequence::Save);
  file->addAction(
      tr("Save pipeline as…"), this,
      [this] {
        const QString path =
            QFileDialog::getSaveFileName(this, tr("Save pipeline"), session_.path(), tr("Pipelines (*.json)"));
        if (!path.isEmpty()) guarded([&] { save(path); });
      },
      QKeySequence::SaveAs);
  file->addSeparator();
  file->addAction(tr("Quit"), this, &QWidget::close, QKeySequence::Quit);

  auto* edit = menuBar()->addMenu(tr("&Edit"));
  auto* undo = session_.undo_stack().createUndoAction(this);
  auto* redo = session_.undo_stack().createRedoAction(this);
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcut(QKeySequence::Redo);
  edit->addAction(undo);
  edit->addAction(redo);

  auto* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("Colour by height"), this, [this] { scene_->color_by(PointColor::height); });
  view->addAction(tr("Colour by intensity"), this, [this] { scene_->color_by(PointColor::intensity); });
  view->addAction(tr("Colour by tree"), this, [this] { scene_->color_by(PointColor::tree); });
  view->addAction(
      tr("Reset camera"), this, [this] { scene_->reset_camera(); }, Qt::Key_0);

  auto* bar = addToolBar(tr("Run"));
  bar->setObjectName("run");
  run_action_ = bar->addAction(tr("Run"), this, [this] { guarded([&] { run(); }); });
  finish_action_ = bar->addAction(tr("Keep result"), this, [this] { run_->finish(); });
  cancel_action_ = bar->addAction(tr("Cancel"), this, [this] { run_->cancel(); });
  run_action_->setShortcut(Qt::Key_F5);
  finish_action_->setEnabled(false);
  cancel_action_->setEnabled(false);
}

void MainWindow::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    say(QString::fromUtf8(e.what()));
  }
}

void MainWindow::say(const QString& text) {
  log_->appendPlainText(text);
  statusBar()->showMessage(text, 10000);
}

void MainWindow::open(const QString& path) {
  const bool lost = QFileInfo::exists(Session::recovery_path(path));
  if (lost && QMessageBox::question(this, tr("Changes were not saved"),
                                    tr("The program ended before changes to %1 were saved. Take them up again?")
                                        .arg(QFileInfo(path).fileName())) == QMessageBox::Yes)
    session_.recover(path);
  else
    session_.open(path);
  scene_->show_survey(nullptr, nullptr, nullptr, nullptr);
  stems_->show_table(nullptr);
  slice_->show_survey(nullptr, nullptr);
  setWindowTitle(QString::fromStdString(session_.document().title()) + " - Bole");
}

void MainWindow::save(const QString& path) { session_.save(path); }

void MainWindow::run() { start(true); }

void MainWindow::refresh() {
  refresh_again_ = run_->running();
  if (!refresh_again_) start(false);
}

void MainWindow::start(bool sinks) {
  if (!session_.has_document() || run_->running()) return;
  for (const auto& problem : validate(session_.document())) throw bad_input(problem.stage + ": " + problem.message);
  const QString out =
      QFileInfo(session_.path()).absolutePath() + "/" + QFileInfo(session_.path()).completeBaseName() + "_results";
  run_action_->setEnabled(false);
  finish_action_->setEnabled(true);
  cancel_action_->setEnabled(true);
  progress_->setRange(0, 1000);
  progress_->show();
  run_->start(out, sinks);
}

void MainWindow::show_outcome(const RunOutcome& outcome, const Results& results) {
  run_action_->setEnabled(true);
  finish_action_->setEnabled(false);
  cancel_action_->setEnabled(false);
  progress_->hide();
  for (const auto& stage : outcome.stages) {
    pipeline_->set_state(QString::fromStdString(stage.record.id), panel_state(stage),
                         QString::fromStdString(stage.error.empty() ? stage.record.report.message : stage.error));
    say(QString::fromStdString(stage.record.id + ": " +
                               (stage.error.empty() ? stage.record.report.message : stage.error)));
  }
  statusBar()->showMessage(outcome.error.empty() ? tr("Done") : QString::fromStdString(outcome.error));
  auto stems = latest<Table>(outcome, results, "stems");
  scene_->show_survey(latest<PointCloud>(outcome, results, "points"), stems,
                      latest<Table>(outcome, results, "sections"), latest<Trajectory>(outcome, results, "trajectory"));
  slice_->show_survey(stems, latest<PointCloud>(outcome, results, "slice"));
  const auto selected = stems_->selected_tree();
  stems_->show_table(std::move(stems));
  if (selected) stems_->select_tree(*selected);
  if (std::exchange(refresh_again_, false)) guarded([&] { refresh(); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (run_->running() &&
      QMessageBox::question(this, tr("A run is under way"), tr("Cancel the run and close?")) != QMessageBox::Yes)
    return event->ignore();
  if (session_.has_document() && !session_.undo_stack().isClean() && !may_lose_changes()) return event->ignore();
  run_->cancel();
  event->accept();
}

// Asks what to do with changes that are not saved; false: stay.
bool MainWindow::may_lose_changes() {
  const auto answer =
      QMessageBox::question(this, tr("Changes are not saved"), tr("Save the changes to the pipeline?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) guarded([&] { save(session_.path()); });
  if (answer == QMessageBox::Discard) session_.discard_recovery();
  return answer == QMessageBox::Discard || session_.undo_stack().isClean();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.isEmpty()) guarded([&] { open(urls.front().toLocalFile()); });
}

}  // namespace bole::desktop
