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
  const double past_hour_s = past_hour_us * 1e-6;
  jumped_ = false;
  if (!started_) {
    started_ = true;
    const double utc_s = past_hour_s + hour_s * std::nearbyint((capture_time_s - past_hour_s) / hour_s);
    follows_utc_ = std::abs(utc_s - capture_time_s) < max_disagreement_s;
    time_s_ = follows_utc_ ? utc_s : capture_time_s;
  } else {
    // In captures without usable times the capture's clock stands still. Then only the sensor's clock counts.
    const double passed_s = std::max(0.0, capture_time_s - capture_time_s_);
    const double step_s = past_hour_s - past_hour_s_;
    const double unwrapped_s = step_s + hour_s * std::nearbyint((passed_s - step_s) / hour_s);
    jumped_ = std::abs(unwrapped_s - passed_s) > max_disagreement_s && passed_s > 0;
    time_s_ += jumped_ ? passed_s : unwrapped_s;
  }
  capture_time_s_ = capture_time_s;
  past_hour_s_ = past_hour_s;
  return time_s_;
}

}  // namespace bole::io
