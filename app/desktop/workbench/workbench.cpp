#include "workbench/workbench.h"

#include <QFileInfo>
#include <QStatusBar>
#include <utility>

#include "document/stage_roles.h"
#include "look/finding_words.h"
#include "look/icons.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "running/stage_states.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

constexpr int message_ms = 10000, cancelled_code = 3;

}  // namespace

Workbench::Workbench()
    : docks_(*this),
      commands_(new Commands(
          *this, [this](const auto& act) { guarded(act); }, icon_named)),
      run_(new Runner(session_, this)),
      states_(new StageStates(session_, *run_, this)),  // before the panels that show them
      pipeline_(new PipelinePanel(session_, visibility_, *states_, *commands_, this)),
      properties_(new PropertiesPanel(session_, this)),
      scene_(new SceneView(selection_, this)),
      slice_(new SliceView(selection_, this)),
      profile_(new ProfileView(selection_, this)),
      chart_(new ChartView(selection_, this)),
      stems_(new TablePanel(selection_, this)),
      log_(new LogPanel(*commands_, this)) {
  connect_document();
  connect_views();
  keep_commands_up_to_date();
}

void Workbench::connect_document() {
  connect(pipeline_, &PipelinePanel::stage_selected, properties_, &PropertiesPanel::show_stage);
  connect(properties_, &PropertiesPanel::refused, this, &Workbench::complain);
  connect(pipeline_, &PipelinePanel::refused, this, &Workbench::complain);
  connect(&visibility_, &Visibility::changed, this, [this] { guarded([&] { show_survey(run_->survey()); }); });
  connect(run_, &Runner::survey_begun, this, [this] { guarded([&] { show_survey(run_->survey()); }); });
  connect(run_, &Runner::finished, this, &Workbench::show_outcome);
  connect(run_, &Runner::job_ended, this, [this] {
    if (std::exchange(refresh_again_, false)) guarded([&] { refresh(); });
  });
  connect(&session_, &Session::unprotected, this, [this](const QString& why) {
    complain(tr("Changes are not kept until they are saved: %1").arg(finding_words(why)));
  });
  connect(&session_.undo_stack(), &QUndoStack::indexChanged, this, &Workbench::show_title);
  connect(&session_.undo_stack(), &QUndoStack::cleanChanged, this, &Workbench::show_title);
  connect(this, &Workbench::document_saved, this, &Workbench::show_title);
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    // An edit of a result, made, undone or redone, is shown at once. Other options wait for Run.
    if (takes_edits(*session_.document().at(stage.toStdString()).type) && !run_->survey().empty())
      guarded([&] { refresh(); });
  });
}

void Workbench::connect_views() {
  connect(slice_, &SliceView::said, this, &Workbench::say);
  connect(slice_, &SliceView::height_changed, profile_, &ProfileView::set_height);
  connect(profile_, &ProfileView::height_dragged, slice_, &SliceView::set_height);
  connect(scene_, &SceneView::point_picked, this, [this](const QStringList& facts) {
    if (!facts.isEmpty()) hint(facts.join("   "));
  });
}

void Workbench::keep_commands_up_to_date() {
  connect(&session_, &Session::document_replaced, commands_, &Commands::update);
  connect(&selection_, &Selection::changed, commands_, &Commands::update);
  connect(&selection_, &Selection::row_changed, commands_, &Commands::update);
  connect(&selection_, &Selection::view_changed, commands_, &Commands::update);
  connect(run_, &Runner::jobs_changed, commands_, &Commands::update);
  connect(scene_, &SceneView::settings_changed, commands_, &Commands::update);
  connect(slice_, &SliceView::adding_changed, commands_, &Commands::update);
  connect(this, &Workbench::survey_shown, commands_, &Commands::update);
}

When Workbench::with_document() const {
  return {[this] { return session_.has_document(); }, tr("Open a scan, a point cloud, views or a pipeline first.")};
}

When Workbench::with_survey() const {
  return {[this] { return !run_->survey().empty(); }, tr("Run the pipeline first.")};
}

When Workbench::with_tree() const {
  return {[this] { return selection_.tree().has_value(); }, tr("Select a stem first.")};
}

When Workbench::with_row() const {
  return {[this] { return selection_.row().has_value(); }, tr("Select a row first.")};
}

When Workbench::with_run() const {
  return {[this] { return run_->running(); }, tr("No run is under way.")};
}

void Workbench::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    complain(QString::fromUtf8(e.what()));
  }
}

void Workbench::say(const QString& text) { tell(text, LogLevel::info); }

void Workbench::complain(const QString& text) { tell(text, LogLevel::error); }

void Workbench::tell(const QString& text, LogLevel level) {
  log_->add(text, level);
  statusBar()->showMessage(finding_words(text), message_ms);
}

void Workbench::hint(const QString& text) { statusBar()->showMessage(finding_words(text)); }

void Workbench::document_is_open() {
  refresh_again_ = false;
  states_->forget();
  run_->forget_survey();
  selection_.select({});
  selection_.select_view({});
  visibility_.show_all();
  preview_ = {};
  hint({});  // what was said of the document before
  show_survey({});
  if (const auto height = breast_height_m(session_.document())) {
    slice_->set_breast_height(*height);
    profile_->set_breast_height(*height);
  }
  show_title();
  last_export_ = results_folder();
  Q_EMIT document_opened();
}

// The file, a mark while it has changes that are not saved, and what the pipeline is called.
void Workbench::show_title() {
  if (!session_.has_document()) return;
  const QString file = QFileInfo(session_.path()).fileName();
  const QString title = QString::fromStdString(session_.document().title());
  setWindowTitle(title.isEmpty() ? file + "[*] - Bole" : QString("%1[*] - %2 - Bole").arg(file, title));
  setWindowModified(session_.changed());
}

void Workbench::run() {
  if (!session_.has_document())
    throw bad_input("no pipeline is open", "one to run", "Open a scan, a point cloud, views or a pipeline");
  start(true, results_folder());
}

void Workbench::export_to(const QString& folder) { start(true, folder); }

void Workbench::run_without_files() { start(false, results_folder(), true); }

void Workbench::refresh() {
  refresh_again_ = run_->running();
  if (!refresh_again_) start(false, results_folder());
}

void Workbench::start(bool sinks, const QString& folder, bool asked) {
  if (!session_.has_document()) return;
  for (const auto& problem : pipeline::validate(session_.document()))
    throw bad_input(problem.stage + ": " + problem.message);
  if (sinks) last_export_ = folder;
  run_->start(folder, sinks, asked);
  Q_EMIT run_started();
}

QString Workbench::results_folder() const {
  const QFileInfo file(session_.path());
  return file.absolutePath() + "/" + file.completeBaseName() + "_results";
}

void Workbench::show_preview(const Survey& preview, bool elsewhere) {
  if (!run_->survey().empty()) return;
  preview_ = preview;
  preview_elsewhere_ = elsewhere;
  show_in_scene({});
  Q_EMIT preview_shown();
}

// Until there is a survey its preview stands for it in the 3-D view.
void Workbench::show_in_scene(const Survey& survey) {
  if (survey.empty() && run_->survey().empty()) return scene_->show_survey(preview_);
  if (!preview_.empty() && preview_elsewhere_) scene_->show_survey({});  // the camera looks at another place
  preview_ = {};
  scene_->show_survey(survey);
}

void Workbench::show_survey(const Survey& survey) {
  const Survey cuts = visibility_.survey_for(ViewKind::cuts, survey);
  show_in_scene(visibility_.survey_for(ViewKind::scene, survey));
  slice_->show_survey(cuts);
  profile_->show_survey(cuts);
  chart_->show_survey(survey);
  stems_->show_table(survey.stems);
  Q_EMIT survey_shown(survey);
}

void Workbench::show_outcome(const vtkbridge::RunOutcome& outcome) {
  for (const auto& stage : outcome.stages) {
    const bool failed = !stage.error.empty();
    const auto& message = failed ? stage.error : stage.record.report.message;
    if (!failed || outcome.exit_code != cancelled_code)  // by the person, who knows
      tell(QString::fromStdString(stage.record.id + ": " + message), failed ? LogLevel::error : LogLevel::info);
    for (const auto& warning : stage.record.report.warnings)
      tell(QString::fromStdString(stage.record.id + ": " + warning), LogLevel::warning);
  }
  for (const auto& text : outcome.kept_changed) tell(QString::fromStdString(text), LogLevel::warning);
  visibility_.take(run_->outcome(), run_->results());
  hint(outcome.exit_code == cancelled_code ? tr("Cancelled. What is shown stays as it was.")
       : outcome.error.empty()             ? tr("Done")
                                           : QString::fromStdString(outcome.error));
  show_survey(run_->survey());
}

}  // namespace bole::desktop
