// How long the event loop of the window was busy at a stretch.
#pragma once

#include <QAbstractEventDispatcher>
#include <QObject>
#include <algorithm>
#include <chrono>
#include <ctime>

namespace bole::desktop {

// From one waking of the loop to its next falling asleep, in wall time and in processor time of this thread: the second
// does not count what other programs take on a busy machine.
class StallMeter : public QObject {
 public:
  StallMeter() {
    auto* loop = QAbstractEventDispatcher::instance();
    connect(loop, &QAbstractEventDispatcher::awake, this, [this] { begin(); });
    connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] { end(); });
  }
  double longest_s() const { return longest_s_; }
  double longest_busy_s() const { return longest_busy_s_; }

 private:
  static double thread_s() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  void begin() {
    if (awake_) end();  // a turn of the loop that went on without sleeping
    awake_ = true;
    woke_ = std::chrono::steady_clock::now();
    woke_busy_s_ = thread_s();
  }
  void end() {
    if (!awake_) return;
    awake_ = false;
    longest_s_ = std::max(longest_s_, std::chrono::duration<double>(std::chrono::steady_clock::now() - woke_).count());
    longest_busy_s_ = std::max(longest_busy_s_, thread_s() - woke_busy_s_);
  }
  bool awake_ = false;
  std::chrono::steady_clock::time_point woke_;
  double woke_busy_s_ = 0, longest_s_ = 0, longest_busy_s_ = 0;
};

}  // namespace bole::desktop
