#include "rows/core/frame_plants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/error.h"
#include "rows/core/plant_grid.h"

namespace bole::rows {
namespace {

constexpr double deg = std::numbers::pi / 180;
constexpr int most_shifts = 200;
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
    for (int k = 0; k < most_shifts; ++k) {
      Eigen::Vector2d shift = Eigen::Vector2d::Zero();
      const auto near = grid.within(at, o.bandwidth);
      for (const int j : near) shift += (plan[static_cast<std::size_t>(j)] - at) / static_cast<double>(near.size());
      at += shift;
      if (shift.norm() < still * o.bandwidth) break;
    }
    std::size_t m = 0;
    while (m < modes.size() && (modes[m] - at).norm() > o.bandwidth / 2) ++m;
    if (m == modes.size()) modes.push_back(at), members.emplace_back();
    members[m].push_back(i);
  }
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (std::ssize(members[m]) >= o.points_min) order.push_back(m);
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

Table trunk_centres(const PointCloud& plants, const TrunkOptions& o, Report& report) {
  const auto& label = plants.values<std::int32_t>(plant_column);
  std::map<std::int32_t, std::map<std::int64_t, std::vector<Eigen::Vector2d>>> layers;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (const Eigen::Vector3d p = plants.position(i); label[i] > 0 && p.allFinite())
      layers[label[i]][static_cast<std::int64_t>(std::floor(p.z() / o.layer_height))].push_back(p.head<2>());

  std::vector<double> x, y;
  std::vector<std::int64_t> id, trunk_layers, points;
  std::int64_t without = 0;
  for (const auto& [plant, by_height] : layers) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::int64_t used = 0, count = 0;
    for (const auto& [height, layer] : by_height) {
      Eigen::Vector2d lo = layer.front(), hi = lo;
      for (const auto& p : layer) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
      if (hi.x() - lo.x() > o.d_x || hi.y() - lo.y() > o.d_y) continue;
      ++used;
      for (const auto& p : layer) sum += p, ++count;
    }
    if (used < o.layers_min) {
      ++without;
      continue;
    }
    x.push_back(sum.x() / static_cast<double>(count)), y.push_back(sum.y() / static_cast<double>(count));
    id.push_back(plant), trunk_layers.push_back(used), points.push_back(count);
  }
  if (without > 0)
    report.warn(
        fmt::format("{} clusters have fewer than {} trunk layers and are no plants: raise d_x and d_y where "
                    "trunks are thicker",
                    without, o.layers_min));
  report.counts["plants"] = std::ssize(x);
  report.message = fmt::format("{} plants", x.size());
  Table t;
  t.set("tree_id", id), t.set("x_m", x), t.set("y_m", y), t.set("layers", trunk_layers), t.set("points", points);
  t.facts["axes"] = std::string(axes_name(plants.axes));
  return t;
}

Table place_stems(const Table& stems, const PlaceOptions& o) {
  const double c = std::cos(o.yaw_deg * deg), s = std::sin(o.yaw_deg * deg);
  auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double px = x[i], py = y[i];
    x[i] = o.x + c * px - s * py, y[i] = o.y + s * px + c * py;
  }
  Table placed = stems;
  placed.set("x_m", std::move(x)), placed.set("y_m", std::move(y));
  placed.facts["axes"] = "global";
  return placed;
}

}  // namespace bole::rows
