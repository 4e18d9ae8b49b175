#include "shell/startup_time.h"

#include <time.h>
#include <unistd.h>

#include <QApplication>
#include <QTimer>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "shell/main_window.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Since the kernel made the process: what the loader takes counts too.
double since_process_start() {
  std::ifstream in("/proc/self/stat");
  std::stringstream text;
  text << in.rdbuf();
  std::istringstream fields(text.str().substr(text.str().rfind(')') + 2));
  std::string field;
  for (int i = 0; i < 20; ++i) fields >> field;  // the 22nd of all: start time in ticks since boot
  return seconds(CLOCK_BOOTTIME) - std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

long resident_mib() {
  std::ifstream in("/proc/self/statm");
  long pages = 0, resident = 0;
  in >> pages >> resident;
  return resident * sysconf(_SC_PAGESIZE) / (1 << 20);
}

void print(const char* what) {
  std::printf("%s: %.2f s, %.2f s of CPU, %ld MiB of memory\n", what, since_process_start(),
              seconds(CLOCK_PROCESS_CPUTIME_ID), resident_mib());
  std::fflush(stdout);
}

}  // namespace

void time_startup(MainWindow& window) {
  const auto asked = std::make_shared<double>(0);
  const auto done = std::make_shared<bool>(false);
  // A timer of no wait fires when everything that was due, the first painting included, has been done.
  QTimer::singleShot(0, &window, [&window, asked] {
    QApplication::processEvents();
    print("window shown");
    *asked = seconds(CLOCK_MONOTONIC);
    window.commands().trigger("document.open_sample");
  });
  QObject::connect(&window, &MainWindow::survey_shown, &window, [&window, asked, done](const Survey& survey) {
    if (survey.empty() || *done) return;
    *done = survey.stems != nullptr;
    QApplication::processEvents();
    print(*done ? "sample measured" : "sample seen");
    std::printf("  %.2f s after it was asked for\n", seconds(CLOCK_MONOTONIC) - *asked);
    std::fflush(stdout);
    if (*done) {
      window.session().discard_recovery();
      QTimer::singleShot(0, &window, [] { QApplication::exit(0); });
    }
  });
}

}  // namespace bole::desktop
