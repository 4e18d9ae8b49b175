// What was opened is seen at once: its points or its first frame, what it is, and one button for the next step.
#include "running/first_look.h"

#include <QVBoxLayout>

#include "features/first_look/next_step.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

NextStep* add_line_above_the_views(Workbench& bench) {
  auto* views = bench.takeCentralWidget();
  auto* middle = new QWidget(&bench);
  auto* line = new NextStep(bench, middle);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(line);
  layout->addWidget(views, 1);
  bench.setCentralWidget(middle);
  return line;
}

}  // namespace

void install_first_look(Workbench& bench) {
  auto* b = &bench;
  auto* line = add_line_above_the_views(bench);
  auto* look = new FirstLook(b);
  QObject::connect(b, &Workbench::document_opened, line, [b, line, look] {
    line->show_opened();
    look->look(b->session().document());
  });
  QObject::connect(b, &Workbench::run_started, look, &FirstLook::stop);  // it reads the same file
  QObject::connect(look, &FirstLook::seen, line, [b, line](const std::shared_ptr<const FirstSeen>& seen) {
    line->show_seen(*seen);
    b->guarded([&] { b->show_preview(seen->survey, seen->of_sensor); });
    if (!seen->large.isEmpty()) b->log().add(seen->large, LogLevel::info);
    for (const auto& warning : seen->warnings) b->log().add(warning, LogLevel::warning);
  });
  QObject::connect(look, &FirstLook::preparing, line, &NextStep::show_preparing);
  QObject::connect(look, &FirstLook::failed, line, &NextStep::show_problem);
  QObject::connect(b, &Workbench::survey_shown, line, &NextStep::show_survey);
}

}  // namespace bole::desktop
