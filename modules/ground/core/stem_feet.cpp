#include "ground/core/stem_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground/core/local_plane.h"

namespace bole::ground {
namespace {

constexpr std::size_t max_neighbours = 8;
constexpr double above_feet_m = 0.25;   // what is higher than this above the plane of the feet is no ground there
constexpr double unknown_slope = 0.25;  // per metre of distance, where too few feet tell the slope

std::uint32_t cell_at(const GridShape& shape, const Eigen::Vector3d& p) {
  return static_cast<std::uint32_t>(
      shape.index(std::clamp(shape.column(p.x()), 0, shape.nx - 1), std::clamp(shape.row(p.y()), 0, shape.ny - 1)));
}

// Height of the ground that the nearest feet tell at a place. Feet that stand out above the others are hidden by
// something and do not count.
struct FeetPlane {
  double height = 0, slack = 0;
};

FeetPlane plane_of(std::vector<Eigen::Vector3d> feet, const Eigen::Vector2d& at) {
  FeetPlane out;
  for (int round = 0; round < 3; ++round) {
    PlaneFit fit;
    double nearest = std::numeric_limits<double>::infinity(), spread = 0, lowest = nearest;
    for (const auto& f : feet) {
      const Eigen::Vector2d d = f.head<2>() - at;
      const double weight = 1.0 / (d.squaredNorm() + 1.0);
      fit.add(d.x(), d.y(), f.z(), weight);
      spread += weight * d.squaredNorm();
      nearest = std::min(nearest, d.norm()), lowest = std::min(lowest, f.z());
    }
    if (feet.size() < 4) return {lowest, unknown_slope * nearest};
    const auto plane = fit.solve(0.02 * spread);
    out.height = plane(0);
    const auto high = [&](const Eigen::Vector3d& f) {
      const Eigen::Vector2d d = f.head<2>() - at;
      return f.z() > plane(0) + plane(1) * d.x() + plane(2) * d.y() + above_feet_m;
    };
    const auto kept = std::remove_if(feet.begin(), feet.end(), high);
    if (kept == feet.end()) break;
    feet.erase(kept, feet.end());
  }
  return out;
}

}  // namespace

std::vector<std::uint32_t> columns_through(const std::vector<UprightColumn>& columns, const GridShape& shape,
                                           const std::vector<float>& terrain) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < columns.size(); ++i) {
    const auto z = static_cast<double>(terrain[cell_at(shape, columns[i].foot)]);
    if (columns[i].foot.z() < z - max_foot_depth_m && columns[i].top_z > z + max_foot_depth_m) out.push_back(i);
  }
  return out;
}

FootedCandidates with_feet(const std::vector<LowPoint>& candidates, const std::vector<UprightColumn>& columns,
                           const std::vector<std::uint32_t>& low, const GridShape& shape, double reach_m) {
  const auto nearest_feet = [&](const Eigen::Vector2d& at) {
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < columns.size(); ++i)
      order.emplace_back((columns[i].foot.head<2>() - at).squaredNorm(), i);
    const auto n = std::min(max_neighbours, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end());
    std::vector<Eigen::Vector3d> feet;
    for (std::size_t k = 0; k < n; ++k) feet.push_back(columns[order[k].second].foot);
    return feet;
  };
  const auto near_low_foot = [&](const Eigen::Vector2d& at) {
    return std::any_of(low.begin(), low.end(),
                       [&](std::uint32_t i) { return (columns[i].foot.head<2>() - at).norm() < reach_m; });
  };
  std::vector<LowPoint> kept;
  for (const auto& c : candidates) {
    const Eigen::Vector2d at = c.position.head<2>();
    if (near_low_foot(at)) {
      const auto plane = plane_of(nearest_feet(at), at);
      if (c.position.z() > plane.height + plane.slack + above_feet_m) continue;
    }
    kept.push_back(c);
  }
  std::vector<std::pair<LowPoint, bool>> all;
  for (const auto i : low) all.push_back({{columns[i].foot, cell_at(shape, columns[i].foot)}, true});
  for (const auto& c : kept) all.emplace_back(c, false);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first.cell < b.first.cell; });
  FootedCandidates out;
  for (const auto& [candidate, foot] : all) {
    if (!out.candidates.empty() && out.candidates.back().cell == candidate.cell) continue;
    if (foot) out.feet.push_back(static_cast<std::uint32_t>(out.candidates.size()));
    out.candidates.push_back(candidate);
  }
  return out;
}

}  // namespace bole::ground
