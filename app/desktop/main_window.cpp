#include "main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>

#include "behaviors/review_behavior.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

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
      review_(new ReviewBehavior(selection_, this)),
      pipeline_(new PipelinePanel(session_, this)),
      properties_(new PropertiesPanel(session_, this)),
      scene_(new SceneView(selection_, this)),
      slice_(new SliceView(selection_, this)),
      profile_(new ProfileView(selection_, this)),
      chart_(new ChartView(selection_, this)),
      stems_(new TablePanel(selection_, this)),
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
  connect_views();
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    // An edit of a stem, made, undone or redone, is seen at once; other options wait for Run.
    if (session_.document().at(stage.toStdString()).type->name == "stems.edit" && scene_->has_survey())
      guarded([&] { refresh(); });
  });
}

void MainWindow::connect_views() {
  connect(stems_, &TablePanel::edit_requested, this,
          [this](const StemEdit& edit) { guarded([&] { edit_->apply(edit); }); });
  connect(slice_, &SliceView::edits_requested, this,
          [this](const std::vector<StemEdit>& edits) { guarded([&] { edit_->apply(edits); }); });
  connect(slice_, &SliceView::said, this, &MainWindow::say);
  connect(slice_, &SliceView::height_changed, profile_, &ProfileView::set_height);
  connect(profile_, &ProfileView::height_dragged, slice_, &SliceView::set_height);
  connect(scene_, &SceneView::point_picked, this, [this](const QStringList& facts) {
    if (!facts.isEmpty()) statusBar()->showMessage(facts.join("   "));
  });
  connect(review_, &ReviewBehavior::moved, this, [this](std::int64_t tree) {
    scene_->zoom_to_tree(tree);
    statusBar()->showMessage(tr("%n stem(s) to look at", nullptr, static_cast<int>(review_->open_stems())));
  });
  connect(review_, &ReviewBehavior::nothing_left, this,
          [this] { say(tr("Every stem is accepted, rejected or edited.")); });
}

void MainWindow::make_docks() {
  QDockWidget* below = nullptr;
  const auto dock = [&, this](const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* d = new QDockWidget(title, this);
    d->setObjectName(title);
    d->setWidget(widget);
    addDockWidget(area, d);
    if (area == Qt::BottomDockWidgetArea) below = d;
  };
  dock(tr("Pipeline"), pipeline_, Qt::LeftDockWidgetArea);
  dock(tr("Options"), properties_, Qt::LeftDockWidgetArea);
  auto* stems = new QWidget(this);
  auto* filter = new QLineEdit(stems);
  filter->setPlaceholderText(tr("Filter: poor, check, a number…"));
  filter->setClearButtonEnabled(true);
  connect(filter, &QLineEdit::textChanged, stems_, &TablePanel::filter);
  auto* layout = new QVBoxLayout(stems);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(filter);
  layout->addWidget(stems_);
  dock(tr("Stems"), stems, Qt::BottomDockWidgetArea);
  dock(tr("Chart"), chart_, Qt::BottomDockWidgetArea);
  dock(tr("Log"), log_, Qt::LeftDockWidgetArea);
  dock(tr("Slice"), slice_, Qt::RightDockWidgetArea);
  dock(tr("Profile"), profile_, Qt::RightDockWidgetArea);
  resizeDocks({below}, {260}, Qt::Vertical);  // the view gets the rest
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

  make_stem_menu();
  make_view_menu();

  auto* bar = addToolBar(tr("Run"));
  bar->setObjectName("run");
  run_action_ = bar->addAction(tr("Run"), this, [this] { guarded([&] { run(); }); });
  finish_action_ = bar->addAction(tr("Keep result"), this, [this] { run_->finish(); });
  cancel_action_ = bar->addAction(tr("Cancel"), this, [this] { run_->cancel(); });
  run_action_->setShortcut(Qt::Key_F5);
  finish_action_->setEnabled(false);
  cancel_action_->setEnabled(false);
}

void MainWindow::make_stem_menu() {
  auto* menu = menuBar()->addMenu(tr("&Stem"));
  menu->addAction(tr("Next doubtful stem"), review_, &ReviewBehavior::next, QKeySequence("Ctrl+Right"));
  menu->addAction(tr("Previous doubtful stem"), review_, &ReviewBehavior::previous, QKeySequence("Ctrl+Left"));
  menu->addAction(
      tr("Zoom to the selected stem"), this,
      [this] {
        if (selection_.tree()) scene_->zoom_to_tree(*selection_.tree());
      },
      Qt::Key_Z);
  menu->addSeparator();
  menu->addActions(stems_->actions());
  auto* add = menu->addAction(tr("Add a tree by a circle"));
  add->setCheckable(true);
  add->setShortcut(Qt::Key_C);
  connect(add, &QAction::toggled, slice_, &SliceView::set_adding);
  connect(slice_, &SliceView::adding_changed, add, &QAction::setChecked);
}

void MainWindow::make_view_menu() {
  auto* view = menuBar()->addMenu(tr("&View"));
  color_menu_ = view->addMenu(tr("Colour points by"));
  connect(color_menu_, &QMenu::aboutToShow, this, [this] {
    color_menu_->clear();
    for (const auto& array : scene_->colorable()) {
      auto* action = color_menu_->addAction(QString::fromStdString(array).replace('_', ' '));
      connect(action, &QAction::triggered, this, [this, array] { scene_->color_by(array); });
    }
  });
  const auto look = [&, this](const QString& text, int key, const Eigen::Vector3d& along, const Eigen::Vector3d& up) {
    view->addAction(
        text, this, [this, along, up] { scene_->look_along(along, up); }, QKeySequence(key));
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  view->addAction(
      tr("Whole survey"), this, [this] { scene_->reset_camera(); }, Qt::Key_0);
  look(tr("From above"), Qt::Key_8, -z, y);
  look(tr("From the south"), Qt::Key_2, y, z);
  look(tr("From the west"), Qt::Key_4, x, z);
  look(tr("From the east"), Qt::Key_6, -x, z);
  auto* parallel = view->addAction(tr("Parallel projection"));
  parallel->setCheckable(true);
  parallel->setShortcut(Qt::Key_5);
  connect(parallel, &QAction::toggled, scene_, &SceneView::set_parallel);
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
  run_->forget_survey();
  selection_.select({});
  show_survey({});
  for (const auto& node : session_.document().stages())
    if (node.type->name == "stems.slice") {
      const double height = std::get<double>(node.options.get("height"));
      slice_->set_breast_height(height);
      profile_->set_breast_height(height);
    }
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

void MainWindow::show_survey(const Survey& survey) {
  scene_->show_survey(survey);
  slice_->show_survey(survey);
  profile_->show_survey(survey);
  chart_->show_survey(survey);
  review_->show_survey(survey);
  stems_->show_table(survey.stems);
}

void MainWindow::show_outcome(const RunOutcome& outcome) {
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
  show_survey(run_->survey());
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
