// Lessons inside the window: a panel with steps, tasks and questions about the student's own run.
#include <QDockWidget>

#include "features/lesson/lesson_check.h"
#include "features/lesson/lesson_guide.h"
#include "features/lesson/lesson_panel.h"
#include "features/lesson/lesson_reader.h"
#include "features/lesson/lesson_words.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

// Those that fit this window; what is wrong with another one stands in the log.
std::vector<Lesson> fitting_lessons(Workbench& bench) {
  std::vector<std::string> problems;
  std::vector<Lesson> fitting;
  WindowNames names{{}, {"lesson"}};
  for (const auto& entry : bench.commands().entries())
    if (entry->action) names.commands << entry->command.id;
  for (const auto* dock : bench.docks().all()) names.panels << dock->objectName();
  for (const auto& lesson : shipped_lessons(problems)) {
    try {
      check_lesson(lesson, names);
      fitting.push_back(lesson);
    } catch (const Error& e) {
      problems.emplace_back(e.what());
    }
  }
  for (const auto& problem : problems) bench.log().add(QString::fromStdString(problem), LogLevel::error);
  return fitting;
}

void make_lesson_commands(Workbench& bench, LessonGuide* guide) {
  auto& commands = bench.commands();
  commands.add_submenu({.id = "lesson.menu", .title = Workbench::tr("Lessons"), .place = in_menu(Menu::help)});
  commands.add({.id = "lesson.list",
                .text = Workbench::tr("Show the panel of lessons"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [b = &bench] { b->docks().raise("lesson"); }});
  for (const auto& lesson : guide->lessons())
    commands.add({.id = "lesson.open." + QString::fromStdString(lesson.id),
                  .text = lesson_text(lesson.title),
                  .places = {in_submenu("lesson.menu")},
                  .act = [guide, id = lesson.id] { guide->begin(id); }});
  const auto during = [guide](const std::function<bool()>& also, const QString& otherwise) {
    return When{[guide, also] { return guide->lesson() != nullptr && also(); }, otherwise};
  };
  const QString none = Workbench::tr("Open a lesson first.");
  commands.add({.id = "lesson.next",
                .text = Workbench::tr("Next step"),
                .key = QKeySequence("Ctrl+PgDown"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [guide] { guide->go(guide->step_index() + 1); },
                .enabled_when = during(
                    [guide] {
                      return guide->may_go_on() &&
                             guide->step_index() + 1 < static_cast<int>(guide->lesson()->steps.size());
                    },
                    Workbench::tr("First do what this step of the lesson needs; the last step has no next one."))});
  commands.add({.id = "lesson.back",
                .text = Workbench::tr("Step back"),
                .key = QKeySequence("Ctrl+PgUp"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [guide] { guide->go(guide->step_index() - 1); },
                .enabled_when = during([guide] { return guide->step_index() > 0; }, none)});
  commands.add({.id = "lesson.show",
                .text = Workbench::tr("Show me"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [guide] { guide->show_me(); },
                .enabled_when = during([guide] { return !guide->showing(); }, none),
                .tip = Workbench::tr("Does for you what the step needs")});
  commands.add({.id = "lesson.again",
                .text = Workbench::tr("Begin again"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [guide] { guide->begin_again(); },
                .enabled_when = during([] { return true; }, none),
                .tip = Workbench::tr("From the first step; your answers are forgotten")});
  commands.add({.id = "lesson.leave",
                .text = Workbench::tr("All lessons"),
                .places = {in_submenu("lesson.menu", 1)},
                .act = [guide] { guide->leave(); },
                .enabled_when = during([] { return true; }, none),
                .tip = Workbench::tr("Leaves this lesson; it goes on here later")});
}

}  // namespace

void install_lesson(Workbench& bench) {
  auto* guide = new LessonGuide(bench, fitting_lessons(bench));
  make_lesson_commands(bench, guide);
  auto* panel = new LessonPanel(*guide, bench.commands(), &bench);
  bench.docks().add("lesson", Workbench::tr("Lesson"), panel, Qt::LeftDockWidgetArea, "options")->hide();
}

}  // namespace bole::desktop
