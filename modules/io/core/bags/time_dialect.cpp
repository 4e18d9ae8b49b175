#include "io/core/bags/time_dialect.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/option.h"
#include "base/statistics.h"

namespace bole::io {
namespace {

struct TimeUnit {
  double seconds;
  const char* name;
};
constexpr std::array units{TimeUnit{1, "s"}, TimeUnit{1e-3, "ms"}, TimeUnit{1e-6, "us"}, TimeUnit{1e-9, "ns"}};

// A sweep may cover a small sector, but it cannot last much longer than the messages are apart.
constexpr double min_share = 0.03, max_share = 2;
constexpr double same_clock_periods = 2, jump_periods = 3;

template <class F>
double median_of(const std::vector<TimeSample>& samples, F&& value) {
  std::vector<double> values;
  for (const auto& s : samples) values.push_back(value(s));
  return upper_median(std::move(values));
}

std::string milliseconds(double seconds) { return number_text(std::round(seconds * 1e4) / 10) + " ms"; }

// From the clock of the points to that of the stamps. A clock that was set in between gets the stamps from there.
void judge_clock(const std::vector<TimeSample>& samples, double period_s, TimeDialect& out) {
  const auto behind = [&](const TimeSample& s) { return s.stamp_s - s.first * out.unit_s; };
  const double behind_s = median_of(samples, behind);
  out.jump_s = jump_periods * period_s;
  if (std::abs(behind_s) > same_clock_periods * period_s) {
    out.shift_s = behind_s;
    out.warning = "the clock of the points differs from that of the messages by " +
                  number_text(std::round(behind_s * 1e3) / 1e3) +
                  " s: points get the times of the messages' clock, with the start of the sweep at the stamp";
  }
  double max_s = 0;
  for (const auto& s : samples) max_s = std::max(max_s, std::abs(behind(s) - out.shift_s));
  if (max_s > out.jump_s)
    out.warning += (out.warning.empty() ? "" : ". ") +
                   ("the clock of the points jumps by up to " + number_text(std::round(max_s * 1e3) / 1e3) +
                    " s against that of the messages: such frames start at the stamps of their messages");
}

// Where in the sweep the stamp lies, by the signs of the times.
void judge_stamp(const std::vector<TimeSample>& samples, double span_s, TimeDialect& out) {
  const double first_s = out.unit_s * median_of(samples, [](const TimeSample& s) { return s.first; });
  const double last_s = out.unit_s * median_of(samples, [](const TimeSample& s) { return s.last; });
  if (last_s < 0.1 * span_s) {
    out.text += " the stamp of the message, which is the end of the sweep";
    return;
  }
  if (first_s < -0.1 * span_s) {
    out.text += " the stamp of the message, which lies within the sweep";
    return;
  }
  out.text += " the stamp of the message, which is the start of the sweep";
  // No message can be recorded before its sweep has ended.
  const double delay_s = median_of(samples, [](const TimeSample& s) { return s.recorded_s - s.stamp_s; });
  if (delay_s > 1e-3 && delay_s < 0.5 * span_s)
    out.warning = "the messages were recorded " + milliseconds(delay_s) + " after their stamp, but their points last " +
                  milliseconds(last_s) + " from it: the stamp may be the end of the sweep. All times may be late by " +
                  milliseconds(span_s);
}

}  // namespace

std::optional<TimeSample> time_sample(const RawPoints& points, std::int64_t recorded_ns) {
  if (points.time.empty()) return {};
  const auto [first, last] = std::ranges::minmax(points.time);
  return TimeSample{1e-9 * static_cast<double>(points.stamp_ns), 1e-9 * static_cast<double>(recorded_ns), first, last};
}

TimeDialect find_time_dialect(const std::optional<CloudField>& field, const std::vector<TimeSample>& samples,
                              double period_s) {
  TimeDialect out;
  if (!field) {
    out.text = "none";
    return out;
  }
  const std::string name = "'" + field->name + "' (" + std::string(field_type_name(field->type)) + ")";
  double span = 0, far = 0;
  for (const auto& s : samples) {
    span = std::max(span, s.last - s.first);
    far = std::max({far, std::abs(s.first), std::abs(s.last)});
  }
  const auto unit = std::ranges::min_element(
      units, {}, [&](const TimeUnit& u) { return std::abs(std::log(std::max(span, 1e-300) * u.seconds / period_s)); });
  const double span_s = span * unit->seconds;
  constexpr double float_digits = 1e6;  // beyond it a float32 does not resolve a sweep
  if (span <= 0 || span_s < min_share * period_s || span_s > max_share * period_s ||
      (field->type == FieldType::float32 && far > float_digits * span)) {
    out.text = "none";
    out.warning = "the field " + name + " is no time of points: " +
                  (span <= 0 ? "all points of a message have the same value"
                             : "its values span " + number_text(span) + " in a message, and messages are " +
                                   number_text(period_s) + " s apart");
    return out;
  }
  out.unit_s = unit->seconds;
  out.text = name + ", " + unit->name;
  if (far * out.unit_s <= std::max(2.0, 3 * period_s)) {
    out.origin = TimeOrigin::after_stamp;
    out.text += " from";
    judge_stamp(samples, span_s, out);
    return out;
  }
  out.origin = TimeOrigin::own_clock;
  out.text += ", absolute";
  judge_clock(samples, period_s, out);
  return out;
}

TimeDialect livox_dialect(double apart_s, double period_s) {
  TimeDialect out;
  out.origin = TimeOrigin::after_stamp;
  out.unit_s = 1e-9;
  out.from_base = apart_s < same_clock_periods * period_s;
  out.text = std::string("offset_time, ns from the ") + (out.from_base ? "time base" : "stamp") + " of the message";
  if (!out.from_base)
    out.warning = "the time bases of the messages differ from their stamps by up to " +
                  number_text(std::round(apart_s * 1e3) / 1e3) + " s: points are timed from the stamps";
  return out;
}

}  // namespace bole::io
