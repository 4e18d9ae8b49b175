#include "io/core/bags/message_order.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "io/core/bags/messages.h"

namespace bole::io {
namespace {

// No scanner sends its frames faster.
constexpr std::int64_t at_once_ns = 1'000'000;

// Without the messages in front whose recording time is before 1970, or wrapped to there: no clock showed it, and a
// difference with it may be more than a number holds. Messages are in order of time.
std::span<const BagMessage> timed(const std::vector<BagMessage>& messages) {
  const auto first = std::ranges::lower_bound(messages, 0, {}, &BagMessage::time_ns);
  return {first, messages.end()};
}

bool same_stamp(const Bag& bag, const BagTopic& topic, const BagMessage& a, const BagMessage& b) {
  try {
    const auto stamp_ns = parse_stamp_ns(bag.read(a), topic.encoding);
    return stamp_ns != 0 && stamp_ns == parse_stamp_ns(bag.read(b), topic.encoding);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    return false;  // what is wrong is told when the message is read
  }
}

std::size_t drop_twins(const Bag& bag, const BagTopic& topic, std::vector<BagMessage>& messages, const Run& run) {
  const auto before = messages.size();
  const auto last = std::unique(messages.begin(), messages.end(), [&](const BagMessage& a, const BagMessage& b) {
    run.check_cancel();
    const bool both_timed = a.time_ns >= 0 && b.time_ns >= 0;
    return both_timed && b.time_ns - a.time_ns < at_once_ns && same_stamp(bag, topic, a, b);
  });
  messages.erase(last, messages.end());
  return before - messages.size();
}

// A pause is made up for by messages that come in a burst behind it.
double missing_messages(std::span<const BagMessage> messages, double period_s) {
  double missing = 0, in_bursts = 0;
  for (std::size_t i = 1; i < messages.size(); ++i) {
    const double periods = 1e-9 * static_cast<double>(messages[i].time_ns - messages[i - 1].time_ns) / period_s;
    if (periods > 1.5) missing += std::round(periods) - 1;
    if (periods < 0.5) ++in_bursts;
  }
  return std::max(0.0, missing - in_bursts);
}

}  // namespace

double usual_period_s(const std::vector<BagMessage>& all) {
  const auto messages = timed(all);
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < messages.size(); ++i)
    if (messages[i].time_ns > messages[i - 1].time_ns) steps.push_back(messages[i].time_ns - messages[i - 1].time_ns);
  if (steps.empty()) return 0.1;
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  return 1e-9 * static_cast<double>(steps[steps.size() / 2]);
}

void check_order(const Bag& bag, const BagTopic& topic, std::vector<BagMessage>& messages, const Run& run,
                 Report& report) {
  if (const auto twins = drop_twins(bag, topic, messages, run); twins > 0) {
    report.counts["duplicate_messages"] = static_cast<std::int64_t>(twins);
    report.warn(std::to_string(twins) + " messages of " + topic.name + " are there twice: each is read once");
  }
  const auto in_time = timed(messages);
  if (const auto untimed = messages.size() - in_time.size(); untimed > 0) {
    report.counts["untimed_messages"] = static_cast<std::int64_t>(untimed);
    report.find(Severity::look, "input_damaged",
                std::to_string(untimed) + " of " + std::to_string(messages.size()) + " messages of " + topic.name +
                    " have a recording time that no clock shows (before 1970 or after 2262): they are read first, "
                    "which may not be their place");
  }
  // A recording of a year at 1 kHz has fewer.
  constexpr double max_missing = 1e12;
  const auto missing = std::llround(std::min(missing_messages(in_time, usual_period_s(messages)), max_missing));
  if (missing == 0) return;
  report.counts["missing_messages"] = missing;
  report.find(Severity::look, "messages_missing",
              "about " + std::to_string(missing) + " messages of " + topic.name + " are missing between the " +
                  std::to_string(messages.size()) + " that were recorded: the scan has gaps in time");
}

}  // namespace bole::io
