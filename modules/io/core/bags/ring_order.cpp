#include "io/core/bags/ring_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/core/scans/frame_estimates.h"

namespace bole::io {
namespace {
constexpr std::int64_t max_rings = 512;
}

RingOrder RingOrder::learn(const std::vector<RawPoints>& samples) {
  RingOrder out;
  std::vector<double> sum;
  std::vector<std::size_t> count;
  for (const auto& sample : samples)
    for (std::size_t i = 0; i < sample.ring.size(); ++i) {
      const auto number = sample.ring[i];
      if (number < 0 || number >= max_rings) return {};
      const auto n = static_cast<std::size_t>(number);
      if (n >= sum.size()) {
        sum.resize(n + 1, 0);
        count.resize(n + 1, 0);
      }
      const auto& p = sample.positions[i];
      sum[n] += std::atan2(p.z(), std::hypot(p.x(), p.y()));
      ++count[n];
    }
  // Numbers without a point lie between their neighbours, as they do in a sensor that counts upwards or downwards.
  std::vector<std::size_t> seen;
  for (std::size_t n = 0; n < sum.size(); ++n)
    if (count[n] > 0) seen.push_back(n);
  if (seen.size() < 2) return {};
  std::vector<double> elevation(sum.size());
  for (const auto n : seen) elevation[n] = sum[n] / static_cast<double>(count[n]);
  for (std::size_t n = 0; n < sum.size(); ++n) {
    if (count[n] > 0) continue;
    const auto above = std::ranges::upper_bound(seen, n);
    const auto b = above == seen.end() ? seen.end() - 1 : above == seen.begin() ? above + 1 : above;
    const auto a = b - 1;
    const double share = (static_cast<double>(n) - static_cast<double>(*a)) / static_cast<double>(*b - *a);
    elevation[n] = elevation[*a] + share * (elevation[*b] - elevation[*a]);
  }
  std::vector<std::size_t> order(sum.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t n) { return elevation[n]; });
  out.place_.resize(order.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    out.place_[order[r]] = static_cast<std::uint16_t>(r);
    out.elevations_rad_.push_back(elevation[order[r]]);
  }
  const bool up = std::ranges::is_sorted(order), down = std::ranges::is_sorted(order, std::greater<>());
  out.text_ = up ? "counted from the lowest" : down ? "counted from the highest, turned round" : "sorted by elevation";
  return out;
}

std::uint16_t RingOrder::ring(std::int64_t number, const Eigen::Vector3f& position) const {
  if (number >= 0 && static_cast<std::size_t>(number) < place_.size()) return place_[static_cast<std::size_t>(number)];
  return rings_from_elevations({&position, 1}, elevations_rad_).front();
}

}  // namespace bole::io
