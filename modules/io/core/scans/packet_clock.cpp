#include "io/core/scans/packet_clock.h"

#include <algorithm>
#include <cmath>

namespace bole::io {
namespace {
constexpr double hour_s = 3600;
constexpr double max_disagreement_s = 2;  // between a sensor set by GPS and the capturing computer
}  // namespace

std::int64_t past_hour_difference_us(std::uint32_t a_us, std::uint32_t b_us) {
  constexpr std::int64_t hour = 3'600'000'000;
  const std::int64_t difference = (static_cast<std::int64_t>(b_us) - static_cast<std::int64_t>(a_us)) % hour;
  return difference > hour / 2 ? difference - hour : difference < -hour / 2 ? difference + hour : difference;
}

double PacketClock::time_s(std::uint32_t past_hour_us, double capture_time_s) {
  jumped_ = false;
  if (!started_) {
    started_ = true;
    const double past_hour_s = past_hour_us * 1e-6;
    const double utc_s = past_hour_s + hour_s * std::nearbyint((capture_time_s - past_hour_s) / hour_s);
    follows_utc_ = std::abs(utc_s - capture_time_s) < max_disagreement_s;
    start_s_ = follows_utc_ ? utc_s : capture_time_s;
  } else {
    // In captures without usable times the capture's clock stands still. Then only the sensor's clock counts.
    const double passed_s = std::max(0.0, capture_time_s - capture_time_s_);
    const auto step_us = static_cast<std::int64_t>(past_hour_us) - static_cast<std::int64_t>(past_hour_us_);
    const auto hours = std::llround((passed_s - 1e-6 * static_cast<double>(step_us)) / hour_s);
    const auto unwrapped_us = step_us + 3'600'000'000 * hours;
    const double difference_s = 1e-6 * static_cast<double>(unwrapped_us) - passed_s;
    jumped_ = std::abs(difference_s) > max_disagreement_s && passed_s > 0;
    since_start_us_ += jumped_ ? std::llround(1e6 * passed_s) : unwrapped_us;
  }
  capture_time_s_ = capture_time_s;
  past_hour_us_ = past_hour_us;
  return start_s_ + 1e-6 * static_cast<double>(since_start_us_);
}

}  // namespace bole::io
