// A window with the sample plot, measured: made once, for tests that look at it.
#pragma once

#include <QSignalSpy>
#include <QTest>

#include "behaviors/sample_behavior.h"
#include "main_window.h"

namespace bole::desktop {

// Until no run is under way or waits.
inline bool wait_for_run(MainWindow& window) {
  QSignalSpy finished(&window.runner(), &RunBehavior::finished);
  while (window.runner().running())
    if (!finished.wait(120000)) return false;
  return true;
}

inline bool open_sample_and_wait(MainWindow& window) {
  QSignalSpy shown(&window, &MainWindow::survey_shown);
  window.open_sample();
  for (int i = 0; i < 1200; ++i) {
    if (!window.sample().busy() && !window.runner().running() && window.runner().survey().stems) return true;
    QTest::qWait(100);
  }
  return false;
}

inline QAction* action_of(MainWindow& window, const char* id) {
  auto* action = window.findChild<QAction*>(id);
  if (!action) qCritical("no action %s", id);
  return action;
}

}  // namespace bole::desktop
