#include "console.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/drafts.h"
#include "base/error.h"
#include "base/exit_codes.h"

namespace bole::cli {
namespace {

std::string clock_text(double seconds) {
  const auto s = std::lround(seconds);
  return s < 60 ? fmt::format("{} s", s) : fmt::format("{}:{:02} min", s / 60, s % 60);
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}
ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void ProgressLine::update(std::string_view step, double fraction, std::string_view what) {
  const auto now = std::chrono::steady_clock::now();
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (step != step_) step_ = step, step_start_ = now, tenth_ = -1;
  const double spent = std::chrono::duration<double>(now - step_start_).count();
  const std::string left =
      fraction > 0.02 && spent > 2 ? ", " + clock_text(spent * (1 - fraction) / fraction) + " left" : "";
  if (!terminal_) {
    const int tenth = static_cast<int>(fraction * 10);
    if (tenth == tenth_) return;
    tenth_ = tenth;
    fmt::print(stderr, "{}: {:3.0f} % {}{}\n", step, 100 * fraction, what, left);
    return;
  }
  if (drawn_ && now - last_draw_ < std::chrono::milliseconds(80)) return;
  last_draw_ = now, drawn_ = true;
  const int filled = static_cast<int>(fraction * 24);
  fmt::print(stderr, "\r\033[K{:<10} [{}{}] {:3.0f} % {}{}", step, std::string(static_cast<std::size_t>(filled), '='),
             std::string(static_cast<std::size_t>(24 - filled), ' '), 100 * fraction, what, left);
  std::fflush(stderr);
}

void end_with_parent(long pid) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != pid)
    throw failure(fmt::format("the process {} that started this run has ended", pid), "a parent that waits for it");
}

namespace {

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

// Signals are blocked in every thread and taken by one that waits for them: nothing runs in signal context.
Interrupts::Interrupts(First first) {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  watcher_ = std::jthread([this, first](const std::stop_token& stop) { watch(stop, first); });
}

Interrupts::~Interrupts() {
  watcher_.request_stop();
  watcher_.join();
}

void Interrupts::cancel_now() {
  if (cancel_.stop_requested()) return;
  cancelled_at_ = std::chrono::steady_clock::now();
  cancel_.request_stop();
  fmt::print(stderr, "\nCancelling.\n");
}

void Interrupts::watch(const std::stop_token& stop, First first) {
  const sigset_t set = stop_signals();
  const timespec pause{0, 50'000'000};
  while (!stop.stop_requested()) {
    const int signal_number = sigtimedwait(&set, nullptr, &pause);
    const bool cancels = first == First::cancels || finish_.stop_requested();
    if (signal_number == SIGTERM || (signal_number == SIGINT && cancels)) {
      cancel_now();
    } else if (signal_number == SIGINT) {
      finish_.request_stop();
      fmt::print(
          stderr,
          "\nFinishing with what there is so far. A stage that cannot end early runs to its end; interrupt again "
          "to cancel.\n");
    }
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - cancelled_at_;
    if (cancel_.stop_requested() && waited.count() > patience_s && !stop.stop_requested()) {
      remove_own_drafts();
      fmt::print(stderr, "bole: cancelled on request. Nothing was changed\n");
      std::fflush(nullptr);
      _exit(static_cast<int>(ExitCode::cancelled));
    }
  }
}

}  // namespace bole::cli
