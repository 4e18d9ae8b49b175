#include "main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "behaviors/review_behavior.h"
#include "behaviors/sample_behavior.h"
#include "document/new_document.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "shell/language.h"
#include "shell/layouts.h"
#include "shell/menus.h"
#include "shell/modes.h"
#include "shell/recent_files.h"
#include "shell/shortcut_sheet.h"
#include "shell/theme.h"
#include "shell/welcome.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"
#include "window_features.h"

namespace bole::desktop {
namespace {

vtkbridge::StageState panel_state(const vtkbridge::StageOutcome& stage) {
  switch (stage.state) {
    case bole::vtkbridge::StageState::done:
    case bole::vtkbridge::StageState::from_cache:
      return stage.record.report.warnings.empty() ? vtkbridge::StageState::done : vtkbridge::StageState::warning;
    case bole::vtkbridge::StageState::failed:
      return vtkbridge::StageState::failed;
    default:
      return vtkbridge::StageState::idle;
  }
}

}  // namespace

MainWindow::MainWindow()
    : docks_(*this),
      run_(new RunBehavior(session_, this)),
      sample_(new SampleBehavior(this)),
      edit_(new EditBehavior(session_, this)),
      review_(new ReviewBehavior(selection_, this)),
      pipeline_(new PipelinePanel(session_, visibility_, this)),
      properties_(new PropertiesPanel(session_, this)),
      scene_(new SceneView(selection_, this)),
      slice_(new SliceView(selection_, this)),
      profile_(new ProfileView(selection_, this)),
      chart_(new ChartView(selection_, this)),
      stems_(new TablePanel(selection_, this)),
      log_(new LogPanel(this)) {
  setWindowTitle(tr("Bole"));
  resize(QSize(1600, 1000).boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  setAcceptDrops(true);
  setCentralWidget(scene_);
  make_docks();
  make_menus();
  connect_document();
  connect_views();
  install_features(*this);
  show_welcome(*this);
  for (auto* menu : menus_) menu->menuAction()->setVisible(!menu->isEmpty());
}

void MainWindow::make_menus() {
  const QString titles[] = {tr("&File"), tr("&Edit"), tr("&Run"), tr("&Stem"), tr("&View"), tr("&Tools"), tr("&Help")};
  const char* names[] = {"file", "edit", "run", "stem", "view", "tools", "help"};
  for (std::size_t i = 0; i < menus_.size(); ++i) {
    menus_[i] = menuBar()->addMenu(titles[i]);
    menus_[i]->setObjectName(names[i]);
  }
  for (auto* make : {make_file_menu, make_edit_menu, make_run_bar, make_stem_menu, make_view_menu}) make(*this);
  menu(Menu::view)->addSeparator();
  for (auto* make : {make_mode_menu, make_layout_menu, make_theme_menu, make_language_menu, make_help_menu})
    make(*this);
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
  connect(properties_, &PropertiesPanel::refused, this, &MainWindow::complain);
  connect(pipeline_, &PipelinePanel::refused, this, &MainWindow::complain);
  connect(&visibility_, &Visibility::changed, this, [this] { guarded([&] { show_survey(run_->survey()); }); });
  connect(sample_, &SampleBehavior::ready, this, [this](const auto& document, const QString& path) {
    guarded([&] {
      if (!may_lose_changes()) return;
      take_up(sample_pipeline_path(path), [&] { return *document; });
      document_is_open();
      refresh();
    });
  });
  connect(run_, &RunBehavior::progressed, this, [this, last = QString(), job = 0](const QString& stage) mutable {
    const int now = run_->current() ? run_->current()->id : 0;
    if (job == now && last != stage) pipeline_->set_state(last, vtkbridge::StageState::done);
    job = now, last = stage;
    pipeline_->set_state(stage, vtkbridge::StageState::running);
  });
  connect(run_, &RunBehavior::survey_begun, this, [this] { guarded([&] { show_survey(run_->survey()); }); });
  connect(run_, &RunBehavior::finished, this, &MainWindow::show_outcome);
  connect(run_, &RunBehavior::job_ended, this, [this] {
    if (std::exchange(refresh_again_, false)) guarded([&] { refresh(); });
  });
  connect(&session_, &Session::unprotected, this,
          [this](const QString& why) { complain(tr("Changes are not kept until they are saved: %1").arg(why)); });
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    // An edit of a stem, made, undone or redone, is seen at once; other options wait for Run.
    if (session_.document().at(stage.toStdString()).type->name == "stems.edit" && scene_->has_survey())
      guarded([&] { refresh(); });
  });
}

void MainWindow::connect_views() {
  connect(stems_, &TablePanel::edit_requested, this,
          [this](const stems::StemEdit& edit) { guarded([&] { edit_->apply(edit); }); });
  connect(slice_, &SliceView::edits_requested, this,
          [this](const std::vector<stems::StemEdit>& edits) { guarded([&] { edit_->apply(edits); }); });
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
  auto* stems = new QWidget(this);
  auto* filter = new QLineEdit(stems);
  filter->setPlaceholderText(tr("Filter: words, or conditions such as dbh_cm > 20 quality = poor"));
  filter->setClearButtonEnabled(true);
  connect(filter, &QLineEdit::textChanged, this, [this](const QString& text) {
    if (const QString problem = stems_->filter(text); !problem.isEmpty()) statusBar()->showMessage(problem, 10000);
  });
  auto* layout = new QVBoxLayout(stems);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(filter);
  layout->addWidget(stems_);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);  // forms are tall
  docks_.add("pipeline", tr("Pipeline"), pipeline_, Qt::LeftDockWidgetArea);
  docks_.add("options", tr("Options"), properties_, Qt::LeftDockWidgetArea);
  docks_.add("stems", tr("Stems"), stems, Qt::BottomDockWidgetArea);
  auto* below = docks_.add("chart", tr("Chart"), chart_, Qt::BottomDockWidgetArea);
  docks_.add("log", tr("Log"), log_, Qt::LeftDockWidgetArea);
  docks_.add("slice", tr("Slice"), slice_, Qt::RightDockWidgetArea);
  docks_.add("profile", tr("Profile"), profile_, Qt::RightDockWidgetArea);
  resizeDocks({below}, {260}, Qt::Vertical);  // the view gets the rest
  resizeDocks({docks_.find("pipeline"), docks_.find("options")}, {320, 460}, Qt::Vertical);
}

void MainWindow::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    complain(QString::fromUtf8(e.what()));
  }
}

void MainWindow::say(const QString& text) { tell(text, LogLevel::info); }

void MainWindow::complain(const QString& text) { tell(text, LogLevel::error); }

void MainWindow::tell(const QString& text, LogLevel level) {
  log_->add(text, level);
  statusBar()->showMessage(text, 10000);
}

void MainWindow::open(const QString& path) {
  if (!may_lose_changes()) return;
  if (kind_of_file(path) == FileKind::pipeline)
    take_up(path, {});
  else
    take_up(pipeline_path_for_file(path), [&] { return document_for_file(path); });
  document_is_open();
  if (QFileInfo::exists(session_.path())) note_recent_file(session_.path());
}

void MainWindow::take_up(const QString& path, const std::function<pipeline::PipelineDocument()>& make) {
  const bool lost = QFileInfo::exists(Session::recovery_path(path));
  if (lost && QMessageBox::question(this, tr("Changes were not saved"),
                                    tr("The program ended before changes to %1 were saved. Take them up again?")
                                        .arg(QFileInfo(path).fileName())) == QMessageBox::Yes)
    session_.recover(path);
  else if (make && !QFileInfo::exists(path))
    session_.start(make(), path);
  else
    session_.open(path);
}

void MainWindow::document_is_open() {
  refresh_again_ = false;
  pipeline_->forget_states();
  run_->forget_survey();
  selection_.select({});
  visibility_.show_all();
  show_survey({});
  for (const auto& node : session_.document().stages())
    if (node.type->name == "stems.slice") {
      const double height = std::get<double>(node.options.get("height"));
      slice_->set_breast_height(height);
      profile_->set_breast_height(height);
    }
  setWindowTitle(QString::fromStdString(session_.document().title()) + " - Bole");
  last_export_ = results_folder();
  Q_EMIT document_opened();
}

void MainWindow::open_sample() { sample_->prepare(SampleBehavior::default_folder()); }

void MainWindow::save(const QString& path) {
  session_.save(path);
  note_recent_file(path);
  Q_EMIT document_saved();
}

void MainWindow::run() {
  if (!session_.has_document())
    throw bad_input("no pipeline is open", "one to run", "Open a scan, a point cloud or a pipeline");
  start(true, results_folder());
}

void MainWindow::export_to(const QString& folder) { start(true, folder); }

void MainWindow::refresh() {
  refresh_again_ = run_->running();
  if (!refresh_again_) start(false, results_folder());
}

void MainWindow::start(bool sinks, const QString& folder) {
  if (!session_.has_document()) return;
  for (const auto& problem : pipeline::validate(session_.document()))
    throw bad_input(problem.stage + ": " + problem.message);
  if (sinks) last_export_ = folder;
  run_->start(folder, sinks);
  Q_EMIT run_started();
}

QString MainWindow::results_folder() const {
  const QFileInfo file(session_.path());
  return file.absolutePath() + "/" + file.completeBaseName() + "_results";
}

void MainWindow::show_survey(const Survey& survey) {
  const Survey cuts = visibility_.survey_for(ViewKind::cuts, survey);
  scene_->show_survey(visibility_.survey_for(ViewKind::scene, survey));
  slice_->show_survey(cuts);
  profile_->show_survey(cuts);
  chart_->show_survey(survey);
  review_->show_survey(survey);
  stems_->show_table(survey.stems);
  Q_EMIT survey_shown(survey);
}

void MainWindow::show_outcome(const vtkbridge::RunOutcome& outcome) {
  for (const auto& stage : outcome.stages) {
    pipeline_->set_state(QString::fromStdString(stage.record.id), panel_state(stage),
                         QString::fromStdString(stage.error.empty() ? stage.record.report.message : stage.error));
    tell(QString::fromStdString(stage.record.id + ": " +
                                (stage.error.empty() ? stage.record.report.message : stage.error)),
         stage.error.empty() ? LogLevel::info : LogLevel::error);
    for (const auto& warning : stage.record.report.warnings)
      tell(QString::fromStdString(stage.record.id + ": " + warning), LogLevel::warning);
  }
  visibility_.take(run_->outcome(), run_->results());
  statusBar()->showMessage(outcome.error.empty() ? tr("Done") : QString::fromStdString(outcome.error));
  show_survey(run_->survey());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (run_->running() &&
      QMessageBox::question(this, tr("A run is under way"), tr("Cancel the run and close?")) != QMessageBox::Yes)
    return event->ignore();
  if (!may_lose_changes()) return event->ignore();
  run_->cancel_all();
  keep_layout(*this);
  event->accept();
}

bool MainWindow::may_lose_changes() {
  if (!session_.has_document() || session_.undo_stack().isClean()) return true;
  const bool made_here =
      !QFileInfo::exists(session_.path()) && session_.undo_stack().count() == 0 && !session_.recovered();
  if (made_here) return true;  // a pipeline that the program made and nobody changed
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
  if (urls.isEmpty()) return;
  guarded([&] { open(urls.front().toLocalFile()); });
}

}  // namespace bole::desktop
