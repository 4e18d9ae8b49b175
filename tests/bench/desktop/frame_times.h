// Times of frames of the 3-D view, and the memory of the program.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <QApplication>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <numeric>
#include <vector>

#include "views/scene_view.h"

namespace bole::desktop {

using Clock = std::chrono::steady_clock;

inline double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

inline double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Processor times of all threads: means over the frames of drawing, and of bringing the picture to the screen.
inline void report_frames(const char* what, std::vector<double> seconds, std::vector<double> processor,
                          double showing_s, std::size_t drawn) {
  const double drawing_s = std::accumulate(processor.begin(), processor.end(), 0.0);
  std::ranges::sort(seconds);
  std::ranges::sort(processor);
  const auto slow = [](const std::vector<double>& sorted) { return sorted[sorted.size() * 95 / 100]; };
  const auto ms = [&](double s) { return 1000 * s / static_cast<double>(seconds.size()); };
  fmt::print(
      "{:20} {:5.1f} frames/s (median), {:5.1f} (slowest twentieth), processor time {:.1f} ms (slowest twentieth "
      "{:.1f}) + "
      "{:.1f} ms, {} points\n",
      what, 1 / seconds[seconds.size() / 2], 1 / slow(seconds), ms(drawing_s), 1000 * slow(processor), ms(showing_s),
      drawn);
}

inline long resident_mib() {
  std::ifstream in("/proc/self/statm");
  long pages = 0, resident = 0;
  in >> pages >> resident;
  return resident * sysconf(_SC_PAGESIZE) / (1 << 20);
}

// 60 frames, before each of which move() changes the camera.
template <class Move>
void time_frames(SceneView& view, const char* what, Move move) {
  for (int k = 0; k < 12; ++k)
    move(), view.draw_moving_frame(), QApplication::processEvents();  // until the budget has settled
  std::vector<double> seconds, processor;
  double showing_s = 0;
  for (int k = 0; k < 60; ++k) {
    move();
    const auto frame = Clock::now();
    const double begin_s = processor_s();
    view.draw_moving_frame();
    const double drawn_s = processor_s();
    QApplication::processEvents();
    seconds.push_back(since(frame));
    processor.push_back(drawn_s - begin_s);
    showing_s += processor_s() - drawn_s;
  }
  report_frames(what, std::move(seconds), std::move(processor), showing_s, view.drawn_points());
}

}  // namespace bole::desktop
