// The edits of the document and the runs of this session, and two runs side by side.
#include "features/history/compare_window.h"
#include "features/history/history_panel.h"
#include "look/finding_words.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

// Both results are fetched, one after the other, before the window opens.
void compare(Workbench* b, int first, int second) {
  auto sides = std::make_shared<std::vector<CompareWindow::Side>>();
  for (const int id : {first, second})
    if (const auto job = b->runner().job(id); !job || !job->has_result())
      throw bad_input("run " + std::to_string(id) + " gave no result", "two that were not cancelled and did not fail");
  for (const int id : {first, second})
    b->runner().fetch(id, [b, sides, job = b->runner().job(id)](const JobResult& result) {
      sides->push_back({job, result});
      if (sides->size() < 2) return;
      if (sides->front().job->id > sides->back().job->id) std::swap(sides->front(), sides->back());
      auto* window = new CompareWindow((*sides)[0], (*sides)[1], b);
      window->setAttribute(Qt::WA_DeleteOnClose);
      window->show();
    });
}

}  // namespace

void install_history(Workbench& bench) {
  auto* b = &bench;
  auto* history = new HistoryPanel(bench.session(), bench.runner(), b);
  bench.docks().add("history", Workbench::tr("History"), history, Qt::LeftDockWidgetArea, "log");
  QObject::connect(history, &HistoryPanel::compare_asked, b,
                   [b](int first, int second) { b->guarded([&] { compare(b, first, second); }); });
  QObject::connect(history, &HistoryPanel::refused, b, &Workbench::complain);
  QObject::connect(&bench.runner(), &Runner::fetch_failed, b, [b](const QString& why) {
    b->complain(Workbench::tr("The result of the run could not be fetched again: %1").arg(finding_words(why)));
  });
}

}  // namespace bole::desktop
