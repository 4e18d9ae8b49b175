#include "views/frame_pace.h"

#include <cmath>

namespace bole::desktop {
namespace {

constexpr double min_points = 60'000, max_points = 2'500'000, min_fresh = 10'000, max_fresh = 150'000;
constexpr double fresh_share = 0.3, spare_share = 0.1;  // of a frame's time for new points: wanted, not wanted
constexpr double learning = 0.3, max_surprise = 0.5;    // single slow frames (another program's work) count little
constexpr double step_fresh_share = 0.8;                // of the time of a step, where all of it is new
constexpr double fastest_s = 1e-9, slowest_s = 5e-6;    // of one point

}  // namespace

FramePace::Budget FramePace::step() const {
  const auto at_least = [](double points, double least) { return static_cast<std::size_t>(std::max(points, least)); };
  return {at_least(target_s_ / point_s_, min_points), at_least(step_fresh_share * target_s_ / fresh_s_, min_fresh)};
}

// Normalised least mean squares (Widrow and Hoff 1960) of seconds = point_s drawn + fresh_s fresh.
void FramePace::note(double seconds, std::size_t drawn, std::size_t fresh, bool waiting) {
  const double d = static_cast<double>(drawn), f = static_cast<double>(fresh);
  const double expected = point_s_ * d + fresh_s_ * f;
  const double size = d * d + f * f;
  if (size > 0 && expected > 0) {
    const double error = std::clamp(seconds - expected, -max_surprise * expected, max_surprise * expected);
    point_s_ = std::clamp(point_s_ + learning * error * d / size, fastest_s, slowest_s);
    if (f > 0) fresh_s_ = std::clamp(fresh_s_ + learning * error / (f + 0.1 * d), point_s_, slowest_s);
  }
  const double for_fresh_s = (waiting || fresh > 0 ? fresh_share : spare_share) * target_s_;
  const double new_points = std::clamp(for_fresh_s / fresh_s_, min_fresh, max_fresh);
  const double before = static_cast<double>(budget_.points);
  const double all =
      std::clamp((target_s_ - (waiting || fresh > 0 ? for_fresh_s : 0)) / point_s_, 0.5 * before, 1.3 * before);
  budget_ = {static_cast<std::size_t>(std::clamp(all, min_points, max_points)),
             static_cast<std::size_t>(std::min(new_points, max_fresh))};
}

}  // namespace bole::desktop
