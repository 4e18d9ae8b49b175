// The window: a list of panels, views and behaviors around one session.
#pragma once

#include <QMainWindow>

#include "behaviors/edit_behavior.h"
#include "behaviors/run_behavior.h"
#include "document/session.h"
#include "selection/selection.h"

class QAction;
class QMenu;
class QPlainTextEdit;
class QProgressBar;

namespace bole::desktop {

class ChartView;
class PipelinePanel;
class ProfileView;
class PropertiesPanel;
class ReviewBehavior;
class SceneView;
class SliceView;
class TablePanel;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();

  void open(const QString& path);
  void save(const QString& path);
  void run();      // the whole pipeline
  void refresh();  // all but what writes files; after the run under way, when there is one

  Session& session() { return session_; }
  RunBehavior& runner() { return *run_; }
  EditBehavior& editor() { return *edit_; }
  SceneView& scene() { return *scene_; }
  SliceView& slice() { return *slice_; }
  Selection& selection() { return selection_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void start(bool sinks);
  bool may_lose_changes();
  void make_docks();
  void make_actions();
  void make_stem_menu();
  void make_view_menu();
  void connect_views();
  void show_outcome(const RunOutcome& outcome);
  void show_survey(const Survey& survey);
  void say(const QString& text);
  // Errors become a sentence in the log and the status bar.
  void guarded(const std::function<void()>& act);

  Session session_;
  Selection selection_;
  RunBehavior* run_;
  EditBehavior* edit_;
  ReviewBehavior* review_;
  PipelinePanel* pipeline_;
  PropertiesPanel* properties_;
  SceneView* scene_;
  SliceView* slice_;
  ProfileView* profile_;
  ChartView* chart_;
  TablePanel* stems_;
  bool refresh_again_ = false;
  QPlainTextEdit* log_;
  QProgressBar* progress_;
  QMenu* color_menu_ = nullptr;
  QAction *run_action_ = nullptr, *finish_action_ = nullptr, *cancel_action_ = nullptr;
};

}  // namespace bole::desktop
