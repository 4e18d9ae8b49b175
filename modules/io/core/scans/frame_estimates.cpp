#include "io/core/scans/frame_estimates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::io {
namespace {

constexpr std::size_t min_rings = 8, max_rings = 160;

double elevation_rad(const Eigen::Vector3f& p) { return std::atan2(p.z(), std::hypot(p.x(), p.y())); }

}  // namespace

std::vector<double> mean_elevations_rad(std::span<const Eigen::Vector3f> positions,
                                        std::span<const std::uint16_t> rings) {
  std::vector<double> sum;
  std::vector<std::size_t> count;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (rings[i] >= sum.size()) {
      sum.resize(rings[i] + 1U, 0);
      count.resize(rings[i] + 1U, 0);
    }
    sum[rings[i]] += elevation_rad(positions[i]);
    ++count[rings[i]];
  }
  for (std::size_t r = 0; r < sum.size(); ++r)
    sum[r] = count[r] > 0 ? sum[r] / static_cast<double>(count[r]) : (r > 0 ? sum[r - 1] : 0);
  return sum;
}

std::vector<std::uint16_t> rings_from_order(std::span<const Eigen::Vector3f> positions) {
  std::vector<std::uint16_t> turn(positions.size());
  std::size_t turns = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0 && positions[i - 1].y() < 0 && positions[i].y() >= 0 && positions[i].x() > 0 && ++turns >= max_rings)
      return {};
    turn[i] = static_cast<std::uint16_t>(turns);
  }
  if (positions.empty() || ++turns < min_rings) return {};
  const auto means = mean_elevations_rad(positions, turn);
  const bool falling = means.front() > means.back();
  std::size_t against = 0;
  for (std::size_t r = 1; r < means.size(); ++r)
    if ((means[r] < means[r - 1]) != falling) ++against;
  if (against * 8 > turns) return {};
  if (falling)
    std::ranges::transform(turn, turn.begin(),
                           [&](std::uint16_t t) { return static_cast<std::uint16_t>(turns - 1 - t); });
  return turn;
}

std::vector<std::uint16_t> rings_from_elevations(std::span<const Eigen::Vector3f> positions,
                                                 std::span<const double> elevations_rad) {
  std::vector<std::uint16_t> rings(positions.size(), 0);
  if (elevations_rad.size() < 2) return rings;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double e = elevation_rad(positions[i]);
    const auto above =
        std::clamp(std::ranges::lower_bound(elevations_rad, e), elevations_rad.begin() + 1, elevations_rad.end() - 1);
    const auto nearest = e - *(above - 1) < *above - e ? above - 1 : above;
    rings[i] = static_cast<std::uint16_t>(nearest - elevations_rad.begin());
  }
  return rings;
}

std::vector<double> even_elevations_rad(std::span<const Eigen::Vector3f> positions, int rings) {
  std::vector<double> elevations;
  for (const auto& p : positions) elevations.push_back(elevation_rad(p));
  std::vector<double> even(static_cast<std::size_t>(rings), 0);
  if (elevations.empty()) return even;
  const auto quantile = [&](double q) {
    const auto at = elevations.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(elevations.size() - 1));
    std::ranges::nth_element(elevations, at);
    return *at;
  };
  const double low = quantile(0.005), high = quantile(0.995);
  for (int r = 0; r < rings; ++r)
    even[static_cast<std::size_t>(r)] = rings > 1 ? low + (high - low) * r / (rings - 1) : low;
  return even;
}

std::vector<float> times_from_azimuths(std::span<const Eigen::Vector3f> positions, double period_s) {
  std::vector<float> times;
  times.reserve(positions.size());
  for (const auto& p : positions)
    times.push_back(static_cast<float>(period_s / 2 * (1 - std::atan2(p.y(), p.x()) / std::numbers::pi)));
  return times;
}

}  // namespace bole::io
