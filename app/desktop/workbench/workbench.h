// The window as features see it: the document, what is selected and shown, the runs, the views, and the services of the
// window (commands, docks, messages). The shell makes the window itself of it.
#pragma once

#include <QMainWindow>
#include <functional>

#include "commands/commands.h"
#include "document/selection.h"
#include "document/session.h"
#include "document/visibility.h"
#include "panels/log_panel.h"
#include "running/runner.h"
#include "workbench/docks.h"

namespace bole::desktop {

class ChartView;
class PipelinePanel;
class ProfileView;
class PropertiesPanel;
class SceneView;
class SliceView;
class StageStates;
class TablePanel;

class Workbench : public QMainWindow {
  Q_OBJECT

 public:
  Workbench();

  // A pipeline; or a cloud, a scan or a folder of views, for which a pipeline is made. Asks first what to do with
  // unsaved changes.
  virtual void open(const QString& path) = 0;
  // A pipeline that the program made, unless `path` holds one already; runs it.
  virtual void open_made(const pipeline::PipelineDocument& document, const QString& path) = 0;

  void run();                             // the whole pipeline; waits for runs that were asked for before
  void run_without_files();               // all but the stages that write files; listed in the history
  void refresh();                         // the same after an edit, not listed; after the current run, if any
  void export_to(const QString& folder);  // the whole pipeline, its files into that folder
  // What the 3-D view shows until a run gives more. `elsewhere`: in other axes than what the run will show.
  void show_preview(const Survey& preview, bool elsewhere);
  QString results_folder() const;  // where a run of the document writes
  QString last_export() const { return last_export_; }

  Session& session() { return session_; }
  Selection& selection() { return selection_; }
  Visibility& visibility() { return visibility_; }
  Runner& runner() { return *run_; }
  StageStates& stage_states() { return *states_; }
  Commands& commands() { return *commands_; }
  Docks& docks() { return docks_; }

  SceneView& scene() { return *scene_; }
  SliceView& slice() { return *slice_; }
  ProfileView& profile() { return *profile_; }
  ChartView& chart() { return *chart_; }
  TablePanel& stems() { return *stems_; }
  PipelinePanel& pipeline() { return *pipeline_; }
  PropertiesPanel& properties() { return *properties_; }
  LogPanel& log() { return *log_; }

  // Conditions that many commands share.
  When with_document() const;
  When with_survey() const;
  When with_tree() const;  // that is selected
  When with_row() const;   // likewise
  When with_run() const;   // that is under way

  void guarded(const std::function<void()>& act);  // errors become a sentence in the log and the status bar
  void say(const QString& text);                   // in the log and the status bar
  void complain(const QString& text);              // likewise, as an error
  void hint(const QString& text);                  // in the status bar alone, until the next one; empty: none

 Q_SIGNALS:
  void document_opened();
  void document_saved();
  void cloud_dropped(const QString& path);  // with Shift: to be looked at beside the survey
  void preview_shown();
  void run_started();
  void survey_shown(const Survey& survey);  // an empty one after a document was opened

 protected:
  void document_is_open();  // another one: forgets what was shown of the one before

 private:
  void tell(const QString& text, LogLevel level);
  void start(bool sinks, const QString& folder, bool asked = false);
  void connect_document();
  void connect_views();
  void keep_commands_up_to_date();
  void show_outcome(const vtkbridge::RunOutcome& outcome);
  void show_survey(const Survey& survey);
  void show_in_scene(const Survey& survey);
  void show_title();

  Session session_;
  Selection selection_;
  Visibility visibility_;
  Docks docks_;
  Commands* commands_;
  Runner* run_;
  StageStates* states_;
  PipelinePanel* pipeline_;
  PropertiesPanel* properties_;
  SceneView* scene_;
  SliceView* slice_;
  ProfileView* profile_;
  ChartView* chart_;
  TablePanel* stems_;
  LogPanel* log_;
  QString last_export_;
  bool refresh_again_ = false;
  Survey preview_;  // of a document that was not run yet
  bool preview_elsewhere_ = false;
};

}  // namespace bole::desktop
