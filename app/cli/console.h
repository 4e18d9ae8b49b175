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

// While it lives, the first Ctrl-C (or SIGTERM) asks to finish with the best so far, the second to cancel. Work that
// has no best so far is cancelled at once.
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
  std::stop_source finish_, cancel_;
  std::jthread watcher_;
};

}  // namespace bole::cli
