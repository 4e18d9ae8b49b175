#include "rows/core/frame/mean_shift.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "rows/core/rows/plant_grid.h"

namespace bole::rows {
namespace {

constexpr int max_shifts = 200;
constexpr double still = 1e-4;  // of the bandwidth

}  // namespace

PointCloud mean_shift(const PointCloud& frame, const MeanShiftOptions& o, const Run& run) {
  Points2 plan;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    plan.push_back(frame.position(i).head<2>());
    if (!plan.back().allFinite())
      throw bad_input(fmt::format("point {} is not finite", i), "finite points", "Cut a region first: it drops them");
  }
  const PlantGrid grid(plan);
  Points2 modes;
  std::vector<std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    run.check_cancel();
    Eigen::Vector2d at = plan[i];
    for (int k = 0; k < max_shifts; ++k) {
      Eigen::Vector2d shift = Eigen::Vector2d::Zero();
      const auto near = grid.within(at, o.bandwidth);
      for (const int j : near) shift += (plan[static_cast<std::size_t>(j)] - at) / static_cast<double>(near.size());
      at += shift;
      if (shift.norm() < still * o.bandwidth) break;
    }
    std::size_t m = 0;
    while (m < modes.size() && (modes[m] - at).norm() > o.bandwidth / 2) ++m;
    if (m == modes.size()) {
      modes.push_back(at);
      members.emplace_back();
    }
    members[m].push_back(i);
  }
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (std::ssize(members[m]) >= o.min_points) order.push_back(m);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(modes[a].x(), modes[a].y()) < std::pair(modes[b].x(), modes[b].y());
  });
  std::vector<std::int32_t> plant(plan.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k)
    for (const auto i : members[order[k]]) plant[i] = static_cast<std::int32_t>(k) + 1;
  PointCloud out = frame;
  out.set_column(plant_column, std::move(plant));
  return out;
}

}  // namespace bole::rows
