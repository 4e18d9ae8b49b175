#include "main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "behaviors/review_behavior.h"
#include "document/scan_document.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "shell/menus.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"
#include "window_features.h"

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
    : docks_(*this),
      run_(new RunBehavior(session_, this)),
      edit_(new EditBehavior(session_, this)),
      review_(new ReviewBehavior(selection_, this)),
      pipeline_(new PipelinePanel(session_, this)),
      properties_(new PropertiesPanel(session_, this)),
      scene_(new SceneView(selection_, this)),
      slice_(new SliceView(selection_, this)),
      profile_(new ProfileView(selection_, this)),
      chart_(new ChartView(selection_, this)),
      stems_(new TablePanel(selection_, this)),
      log_(new LogPanel(this)) {
  setWindowTitle(tr("Bole"));
  resize(1600, 1000);
  setAcceptDrops(true);
  setCentralWidget(scene_);
  make_docks();
  make_menus();
  connect_document();
  connect_views();
  install_features(*this);
  for (auto* menu : menus_) menu->menuAction()->setVisible(!menu->isEmpty());
}

void MainWindow::make_menus() {
  const QString titles[] = {tr("&File"), tr("&Edit"), tr("&Run"), tr("&Stem"), tr("&View"), tr("&Tools"), tr("&Help")};
  for (std::size_t i = 0; i < menus_.size(); ++i) menus_[i] = menuBar()->addMenu(titles[i]);
  for (auto* make : {make_file_menu, make_edit_menu, make_stem_menu, make_view_menu, make_run_bar}) make(*this);
}

QAction* MainWindow::add_action(QMenu* menu, const char* id, const QString& text, const std::function<void()>& act,
                                const QKeySequence& key) {
  auto* action = menu->addAction(text);
  action->setObjectName(id);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [this, act] { guarded(act); });
  return action;
}

void MainWindow::connect_document() {
  connect(pipeline_, &PipelinePanel::stage_selected, properties_, &PropertiesPanel::show_stage);
  connect(properties_, &PropertiesPanel::refused, this, [this](const QString& text) { say(text, LogLevel::error); });
  connect(run_, &RunBehavior::progressed, this,
          [this](const QString& stage) { pipeline_->set_state(stage, StageState::running); });
  connect(run_, &RunBehavior::finished, this, &MainWindow::show_outcome);
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
  connect(slice_, &SliceView::said, this, [this](const QString& text) { say(text); });
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
  docks_.add("pipeline", tr("Pipeline"), pipeline_, Qt::LeftDockWidgetArea);
  docks_.add("options", tr("Options"), properties_, Qt::LeftDockWidgetArea);
  docks_.add("stems", tr("Stems"), stems, Qt::BottomDockWidgetArea);
  auto* below = docks_.add("chart", tr("Chart"), chart_, Qt::BottomDockWidgetArea);
  docks_.add("log", tr("Log"), log_, Qt::LeftDockWidgetArea);
  docks_.add("slice", tr("Slice"), slice_, Qt::RightDockWidgetArea);
  docks_.add("profile", tr("Profile"), profile_, Qt::RightDockWidgetArea);
  resizeDocks({below}, {260}, Qt::Vertical);  // the view gets the rest
}

void MainWindow::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    say(QString::fromUtf8(e.what()), LogLevel::error);
  }
}

void MainWindow::say(const QString& text, LogLevel level) {
  log_->add(text, level);
  statusBar()->showMessage(text, 10000);
}

void MainWindow::open(const QString& given) {
  const bool scan = is_scan(given);
  const QString path = scan ? document_path_for_scan(given) : given;
  const bool lost = QFileInfo::exists(Session::recovery_path(path));
  if (lost && QMessageBox::question(this, tr("Changes were not saved"),
                                    tr("The program ended before changes to %1 were saved. Take them up again?")
                                        .arg(QFileInfo(path).fileName())) == QMessageBox::Yes)
    session_.recover(path);
  else if (scan && !QFileInfo::exists(path))
    session_.begin(document_for_scan(given), path);
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
  Q_EMIT document_opened();
}

void MainWindow::save(const QString& path) { session_.save(path); }

void MainWindow::run() { start(true); }

void MainWindow::refresh() {
  refresh_again_ = run_->running();
  if (!refresh_again_) start(false);
}

void MainWindow::start(bool sinks) {
  if (!session_.has_document()) return;
  for (const auto& problem : validate(session_.document())) throw bad_input(problem.stage + ": " + problem.message);
  run_->start(results_folder(), sinks);
  Q_EMIT run_started();
}

QString MainWindow::results_folder() const {
  const QFileInfo file(session_.path());
  return file.absolutePath() + "/" + file.completeBaseName() + "_results";
}

void MainWindow::show_survey(const Survey& survey) {
  scene_->show_survey(survey);
  slice_->show_survey(survey);
  profile_->show_survey(survey);
  chart_->show_survey(survey);
  review_->show_survey(survey);
  stems_->show_table(survey.stems);
  Q_EMIT survey_shown(survey);
}

void MainWindow::show_outcome(const RunOutcome& outcome) {
  for (const auto& stage : outcome.stages) {
    pipeline_->set_state(QString::fromStdString(stage.record.id), panel_state(stage),
                         QString::fromStdString(stage.error.empty() ? stage.record.report.message : stage.error));
    say(QString::fromStdString(stage.record.id + ": " +
                               (stage.error.empty() ? stage.record.report.message : stage.error)),
        stage.error.empty() ? LogLevel::info : LogLevel::error);
    for (const auto& warning : stage.record.report.warnings)
      say(QString::fromStdString(stage.record.id + ": " + warning), LogLevel::warning);
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
  run_->cancel_all();
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
