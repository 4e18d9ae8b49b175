// The walk of the scan beside the survey: the map as SLAM makes it, and the frames in time.
#include <QTabWidget>

#include "features/walk/frame_bar.h"
#include "features/walk/walk_panel.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

// The walk shares the middle of the window with the survey. It comes to the front while SLAM is at work.
WalkPanel* add_walk(Workbench* b) {
  auto* walk = new WalkPanel(b->session(), b->runner(), b);
  auto* tabs = new QTabWidget(b);
  tabs->setObjectName("centre");
  tabs->setDocumentMode(true);
  auto* survey = b->takeCentralWidget();
  tabs->addTab(survey, Workbench::tr("Survey"));
  tabs->addTab(walk, Workbench::tr("Walk"));
  b->setCentralWidget(tabs);
  QObject::connect(walk, &WalkPanel::live_began, tabs, [tabs, walk] { tabs->setCurrentWidget(walk); });
  QObject::connect(walk, &WalkPanel::live_ended, tabs, [tabs, survey, b] {
    if (b->scene().has_survey()) tabs->setCurrentWidget(survey);
  });
  QObject::connect(walk, &WalkPanel::failed, b, &Workbench::complain);
  return walk;
}

}  // namespace

void install_walk(Workbench& bench) {
  constexpr int section = 2;  // of the menu View
  auto* walk = add_walk(&bench);
  auto* bar = &walk->bar();
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key, const std::function<void()>& act) {
    bench.commands().add({.id = id, .text = text, .key = key, .places = {in_menu(Menu::view, section)}, .act = act});
  };
  add("walk.next_frame", Workbench::tr("Next frame"), QKeySequence("."), [bar] { bar->step(1); });
  add("walk.previous_frame", Workbench::tr("Previous frame"), QKeySequence(","), [bar] { bar->step(-1); });
  add("walk.next_keyframe", Workbench::tr("Next keyframe"), QKeySequence("Ctrl+."), [bar] { bar->step_keyframe(1); });
  add("walk.previous_keyframe", Workbench::tr("Previous keyframe"), QKeySequence("Ctrl+,"),
      [bar] { bar->step_keyframe(-1); });
  add("walk.all", Workbench::tr("Whole walk"), {}, [walk] { walk->view().look_at_all(); });
}

}  // namespace bole::desktop
