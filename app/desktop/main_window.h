// The window: panels, views and behaviors around one session. Menus are filled in shell/, further features in
// window_features.cpp; both hook in through the public face below.
#pragma once

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <array>

#include "behaviors/edit_behavior.h"
#include "behaviors/run_behavior.h"
#include "document/session.h"
#include "document/visibility.h"
#include "panels/log_panel.h"
#include "selection/selection.h"
#include "shell/docks.h"

namespace bole::desktop {

class ChartView;
class PipelinePanel;
class ProfileView;
class PropertiesPanel;
class ReviewBehavior;
class SampleBehavior;
class SceneView;
class SliceView;
class TablePanel;

enum class Menu { file, edit, run, stem, view, tools, help };  // as they stand in the bar
inline constexpr Menu all_menus[] = {Menu::file, Menu::edit,  Menu::run, Menu::stem,
                                     Menu::view, Menu::tools, Menu::help};

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();

  // A pipeline; a cloud or a scan, for which a pipeline is made. Asks first what to do with changes that are not saved.
  void open(const QString& path);
  void open_sample();  // made where it is not there yet, opened and run; in the background
  void save(const QString& path);
  void run();                             // the whole pipeline; after the runs that are asked for already
  void refresh();                         // all but what writes files; after the run under way, when there is one
  void export_to(const QString& folder);  // the whole pipeline, its files into that folder
  QString results_folder() const;         // where a run of the document writes
  QString last_export() const { return last_export_; }

  Session& session() { return session_; }
  RunBehavior& runner() { return *run_; }
  EditBehavior& editor() { return *edit_; }
  ReviewBehavior& review() { return *review_; }
  SceneView& scene() { return *scene_; }
  SliceView& slice() { return *slice_; }
  ProfileView& profile() { return *profile_; }
  ChartView& chart() { return *chart_; }
  TablePanel& stems() { return *stems_; }
  LogPanel& log() { return *log_; }
  PipelinePanel& pipeline() { return *pipeline_; }
  PropertiesPanel& properties() { return *properties_; }
  Selection& selection() { return selection_; }
  Visibility& visibility() { return visibility_; }
  SampleBehavior& sample() { return *sample_; }

  Docks& docks() { return docks_; }
  QMenu* menu(Menu which) { return menus_[static_cast<std::size_t>(which)]; }
  // An action with an id, by which modes, key settings and tests know it. A bole::Error from `act` becomes a sentence.
  QAction* add_action(QMenu* menu, const char* id, const QString& text, const std::function<void()>& act,
                      const QKeySequence& key = {});
  void guarded(const std::function<void()>& act);  // errors become a sentence in the log and the status bar
  void say(const QString& text);                   // in the log and the status bar
  void complain(const QString& text);              // likewise, as an error

 Q_SIGNALS:
  void document_opened();
  void document_saved();
  void run_started();
  void survey_shown(const Survey& survey);  // an empty one after a document was opened

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void tell(const QString& text, LogLevel level);
  void start(bool sinks, const QString& folder);
  bool may_lose_changes();  // asks what to do with changes that are not saved; false: stay
  void document_is_open();
  // The pipeline at `path`, or what a crash left of it; where it was never saved, the one that `make` gives.
  void take_up(const QString& path, const std::function<pipeline::PipelineDocument()>& make);
  void make_menus();
  void make_docks();
  void connect_document();
  void connect_views();
  void show_outcome(const vtkbridge::RunOutcome& outcome);
  void show_survey(const Survey& survey);

  Session session_;
  Selection selection_;
  Visibility visibility_;
  Docks docks_;
  std::array<QMenu*, 7> menus_{};
  RunBehavior* run_;
  SampleBehavior* sample_;
  EditBehavior* edit_;
  ReviewBehavior* review_;
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
};

}  // namespace bole::desktop
