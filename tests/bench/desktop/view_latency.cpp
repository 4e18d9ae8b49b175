// From a key or a click to all views: view_latency DOCUMENT.json [STEMS = 60]. Run it as
//   xvfb-run -a -s "-screen 0 1920x1080x24" build/headless/bin/view_latency survey.json
// Runs the document (at once where its results are cached), then selects stems by clicks in the 3-D view, by Ctrl+Right
// and by the table at 1920 x 1080, changes the theme, and prints how long it took until every view had been painted.
#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>

#include <QSurfaceFormat>
#include <QTest>
#include <cstdlib>

#include "frame_times.h"
#include "panels/table_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "shell/main_window.h"
#include "shell/modes.h"

namespace {

using namespace bole::desktop;

void wait_for_views(MainWindow& window, double at_most_s) {
  const auto start = Clock::now();
  while ((window.runner().running() || !window.runner().survey().stems || !window.scene().refined() ||
          (window.runner().survey().index && !window.runner().survey().index->complete())) &&
         since(start) < at_most_s)
    QApplication::processEvents(QEventLoop::AllEvents, 20);
}

struct Painted {
  double first_frame_s = 0;  // of the 3-D view
  double all_s = 0;
};

// Everything that the event asked to be painted is painted within processEvents().
template <class Act>
Painted painted_after(MainWindow& window, Act act) {
  Painted painted;
  const auto& points = window.scene().points_renderer();
  const auto frames = [&] { return points.frames_drawn() + points.frames_from_kept(); };
  const auto before = frames();
  const auto start = Clock::now();
  const auto swapped = QObject::connect(&window.scene(), &QOpenGLWidget::frameSwapped, [&] {
    if (painted.first_frame_s == 0 && frames() > before) painted.first_frame_s = since(start);
  });
  act();
  QApplication::processEvents();
  window.scene().renderWindow()->WaitForCompletion();
  painted.all_s = since(start);
  QObject::disconnect(swapped);
  QTest::qWait(300);  // the points come back in full, as they do while a person looks
  return painted;
}

void print_times(const char* what, const std::vector<Painted>& painted) {
  if (painted.empty()) return;
  const auto print = [&](const char* until, double Painted::*of) {
    std::vector<double> seconds;
    for (const auto& p : painted) seconds.push_back(p.*of);
    std::ranges::sort(seconds);
    fmt::print("{:30} {:11} {:3} times: median {:.0f} ms, slowest twentieth {:.0f} ms, slowest {:.0f} ms\n", what,
               until, seconds.size(), 1000 * seconds[seconds.size() / 2], 1000 * seconds[seconds.size() * 95 / 100],
               1000 * seconds.back());
  };
  print("first frame", &Painted::first_frame_s);
  print("all", &Painted::all_s);
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  if (argc < 2) {
    fmt::print("view_latency DOCUMENT.json [STEMS]\n");
    return 2;
  }
  QApplication::setApplicationName("Bole bench");
  bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
  bole::report::register_stages(bole::pipeline::StageRegistry::global());
  const int most = argc > 2 ? std::atoi(argv[2]) : 60;
  MainWindow window;
  window.resize(1920, 1080);
  apply_mode(window, shipped_modes().front());
  window.show();
  while (!window.scene().isValid()) QApplication::processEvents();
  QApplication::setActiveWindow(&window);  // no window manager does it under Xvfb
  window.open(QString::fromLocal8Bit(argv[1]));
  window.refresh();
  constexpr double longest_run_s = 1800;
  wait_for_views(window, longest_run_s);
  const auto stems = window.runner().survey().stems;
  if (!stems) {
    fmt::print("the document gave no stems\n");
    return 1;
  }
  fmt::print("{} stems, {} points, {} x {}\n", stems->rows(), window.runner().survey().points->size(), window.width(),
             window.height());
  const auto ids = stems->integers("tree_id");
  const std::size_t count = std::min<std::size_t>(ids.size(), static_cast<std::size_t>(std::max(1, most)));
  std::vector<Painted> by_click, by_key, by_table, by_theme;
  window.scene().reset_camera();
  QTest::qWait(1000);
  wait_for_views(window, longest_run_s);  // all points of it are prepared
  const auto x = stems->numbers("x_m"), y = stems->numbers("y_m"), z = stems->numbers("z_m");
  constexpr double clicked_above_m = 1.3;
  constexpr int themes = 8;
  for (std::size_t i = 0; i < count; ++i) {
    const QPoint at = window.scene().place_of({x[i], y[i], z[i] + clicked_above_m});
    if (!window.scene().rect().contains(at)) continue;
    by_click.push_back(
        painted_after(window, [&] { QTest::mouseClick(&window.scene(), Qt::LeftButton, Qt::NoModifier, at); }));
  }
  for (std::size_t i = 0; i < count; ++i)
    by_key.push_back(
        painted_after(window, [&] { QTest::keyClick(window.windowHandle(), Qt::Key_Right, Qt::ControlModifier); }));
  for (std::size_t i = 0; i < count; ++i)
    by_table.push_back(painted_after(window, [&] { window.stems().select_tree(ids[i]); }));
  for (int k = 0; k < themes; ++k)
    by_theme.push_back(
        painted_after(window, [&] { window.commands().trigger(k % 2 == 0 ? "theme.dark" : "theme.light"); }));
  window.commands().trigger("theme.system");
  print_times("click on a stem in 3-D", by_click);
  print_times("Ctrl+Right, camera to the stem", by_key);
  print_times("row of the table", by_table);
  print_times("light or dark", by_theme);
  return 0;
}
