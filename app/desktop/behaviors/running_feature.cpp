#include "behaviors/running_feature.h"

#include <QTabWidget>

#include "main_window.h"
#include "panels/frame_bar.h"
#include "panels/history_panel.h"
#include "panels/jobs_panel.h"
#include "panels/walk_panel.h"
#include "views/compare_window.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

// The walk shares the middle of the window with the survey, and comes to the front while SLAM is at work.
WalkPanel* add_walk(MainWindow* w) {
  auto* walk = new WalkPanel(w->session(), w->runner(), w);
  auto* tabs = new QTabWidget(w);
  tabs->setObjectName("centre");
  tabs->setDocumentMode(true);
  auto* survey = w->takeCentralWidget();
  tabs->addTab(survey, MainWindow::tr("Survey"));
  tabs->addTab(walk, MainWindow::tr("Walk"));
  w->setCentralWidget(tabs);
  QObject::connect(walk, &WalkPanel::live_began, tabs, [tabs, walk] { tabs->setCurrentWidget(walk); });
  QObject::connect(walk, &WalkPanel::live_ended, tabs, [tabs, survey, w] {
    if (w->scene().has_survey()) tabs->setCurrentWidget(survey);
  });
  QObject::connect(walk, &WalkPanel::failed, w, &MainWindow::complain);
  return walk;
}

void add_frame_actions(MainWindow* w, WalkPanel* walk) {
  auto* menu = w->menu(Menu::view);
  menu->addSeparator();
  const auto add = [&](const char* id, const QString& text, const char* key, auto act) {
    w->add_action(
        menu, id, text, [bar = &walk->bar(), act] { act(*bar); }, QKeySequence(key));
  };
  add("frame_next", MainWindow::tr("Next frame"), ".", [](FrameBar& bar) { bar.step(1); });
  add("frame_previous", MainWindow::tr("Previous frame"), ",", [](FrameBar& bar) { bar.step(-1); });
  add("keyframe_next", MainWindow::tr("Next key frame"), "Ctrl+.", [](FrameBar& bar) { bar.step_keyframe(1); });
  add("keyframe_previous", MainWindow::tr("Previous key frame"), "Ctrl+,",
      [](FrameBar& bar) { bar.step_keyframe(-1); });
  w->add_action(menu, "walk_all", MainWindow::tr("Whole walk"), [walk] { walk->view().look_at_all(); });
}

// Both results are fetched, one after the other, before the window opens.
void compare(MainWindow* w, int first, int second) {
  auto sides = std::make_shared<std::vector<CompareWindow::Side>>();
  for (const int id : {first, second})
    if (const auto job = w->runner().job(id); !job || !job->has_result())
      throw bad_input("run " + std::to_string(id) + " gave no result", "two that were not cancelled and did not fail");
  for (const int id : {first, second})
    w->runner().fetch(id, [w, sides, job = w->runner().job(id)](const JobResult& result) {
      sides->push_back({job, result});
      if (sides->size() < 2) return;
      if (sides->front().job->id > sides->back().job->id) std::swap(sides->front(), sides->back());
      auto* window = new CompareWindow((*sides)[0], (*sides)[1], w);
      window->setAttribute(Qt::WA_DeleteOnClose);
      window->show();
    });
}

}  // namespace

void install_running(MainWindow& window) {
  auto* w = &window;
  auto* walk = add_walk(w);
  add_frame_actions(w, walk);
  w->docks().add("jobs", MainWindow::tr("Jobs"), new JobsPanel(w->runner(), w), Qt::BottomDockWidgetArea, "stems");
  w->docks().raise("stems");
  auto* history = new HistoryPanel(w->session(), w->runner(), w);
  w->docks().add("history", MainWindow::tr("History"), history, Qt::LeftDockWidgetArea, "log");
  QObject::connect(history, &HistoryPanel::compare_asked, w,
                   [w](int first, int second) { w->guarded([&] { compare(w, first, second); }); });
  QObject::connect(history, &HistoryPanel::refused, w, &MainWindow::complain);
  QObject::connect(&w->runner(), &RunBehavior::fetch_failed, w, [w](const QString& why) {
    w->complain(MainWindow::tr("The result of the run could not be had again: %1").arg(why));
  });
}

}  // namespace bole::desktop
