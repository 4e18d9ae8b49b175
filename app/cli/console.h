// What a person sees while a command works, and how they stop it.
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

namespace bole::cli {

// On a terminal one line with a bar and the time left; into a pipe one line per tenth of a step.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(std::string_view step, double fraction, std::string_view what);
  void clear();

 private:
  bool terminal_;
  bool drawn_ = false;
  std::string step_;
  int tenth_ = -1;
  std::chrono::steady_clock::time_point step_start_, last_draw_;
};

// The kernel kills this process when the thread that started it ends, whatever ends that. Throws Error{failed} when the
// parent is another than `pid` by now: it ended before this was called.
void end_with_parent(long pid);

// While it lives, the first Ctrl-C asks to finish with the best so far, the second cancels; SIGTERM always cancels.
// Work that has no best so far is cancelled at once. Work that does not end within patience_s of a cancel (a blocked
// file system, a library that cannot be interrupted) is left: temporary files are removed and the program ends with the
// exit code of a cancel. Results are put in place at the end only, so that nothing is half written.
class Interrupts {
 public:
  enum class First { finishes, cancels };
  explicit Interrupts(First first);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  std::stop_token finish() const { return finish_.get_token(); }
  std::stop_token cancel() const { return cancel_.get_token(); }

 private:
  void watch(const std::stop_token& stop, First first);
  void cancel_now();

  static constexpr double patience_s = 0.35;
  std::stop_source finish_, cancel_;
  std::chrono::steady_clock::time_point cancelled_at_;
  std::jthread watcher_;
};

}  // namespace bole::cli
