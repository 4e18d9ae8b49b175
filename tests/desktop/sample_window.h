// A window with the sample plot, measured: made once, for tests that look at it.
#pragma once

#include <QSignalSpy>
#include <QTest>

#include "features/sample/sample_plot.h"
#include "shell/main_window.h"

namespace bole::desktop {

// Until no run is under way or waits.
inline bool wait_for_run(MainWindow& window) {
  QSignalSpy finished(&window.runner(), &Runner::finished);
  while (window.runner().running())
    if (!finished.wait(120000)) return false;
  return true;
}

inline bool open_sample_and_wait(MainWindow& window) {
  QSignalSpy shown(&window, &MainWindow::survey_shown);
  window.commands().trigger("document.open_sample");
  const auto* sample = window.findChild<SamplePlot*>();
  for (int i = 0; i < 1200; ++i) {
    if (!sample->busy() && !window.runner().running() && window.runner().survey().stems) return true;
    QTest::qWait(100);
  }
  return false;
}

}  // namespace bole::desktop
