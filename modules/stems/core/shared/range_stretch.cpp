#include "stems/core/shared/range_stretch.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>

#include "cloud/core/walk_facts.h"
#include "cloud/core/whole/whole_cloud.h"
#include "cloud/known_facts.h"
#include "stems/core/detect/sensor_positions.h"
#include "stems/core/shared/drawn_mean.h"

namespace bole::stems {
namespace {

// Stems differ by more than their own uncertainty, and all of them err alike by the shape that the fit assumes: on maps
// of five good walks by four sensors the mean was within 0.16 mm per metre of zero.
constexpr double between = 3e-4, shared = 1e-4, expected = 1e-4, weak = 0.05;

}  // namespace

RangeStretchPrior mean_range_stretch(const std::vector<RangeStretchEvidence>& stems) {
  std::vector<SharedEvidence> values;
  for (const auto& e : stems) values.push_back({e.value, e.sd, e.doubt});
  const auto drawn = drawn_to_zero(bounded_mean(values, between, shared, weak), expected);
  return {drawn.mean, drawn.sd};
}

Eigen::Vector2d still_place(const std::vector<Eigen::Vector2d>& stems) {
  Eigen::AlignedBox2d around;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& at : stems) around.extend(at), sum += at;
  if (stems.empty() || around.contains(Eigen::Vector2d::Zero())) return Eigen::Vector2d::Zero();
  return sum / static_cast<double>(stems.size());
}

PointCloud lengthened(const PointCloud& points, const Trajectory* trajectory, const WalkStretch& walk, const Run& run) {
  const auto sensor_of = sensor_of_points(points, trajectory);
  if (!sensor_of) return points;
  const Eigen::Vector2f still = (walk.still - points.origin.head<2>()).cast<float>();
  const bool has_columns = has_sensor_columns(points);
  std::vector<float> x, y;
  if (has_columns) x = points.values<float>(arrays::sensor_x), y = points.values<float>(arrays::sensor_y);
  auto positions = points.positions();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1 << 16), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) {
      const auto sensor = sensor_of(i);
      if (!sensor) continue;
      const Eigen::Vector2f move = static_cast<float>(walk.share) * (sensor->template head<2>() - still);
      positions[i].template head<2>() += move;
      if (has_columns) x[i] += move.x(), y[i] += move.y();
    }
  });
  run.check_cancel();
  PointCloud out = points;
  out.set_positions(std::move(positions));
  out.scale.setZero();
  forget_whole(out.facts);
  set_fact(out.facts, facts::walk_lengthened,
           100 * walk.share + fact_number(points.facts, facts::walk_lengthened).value_or(0));
  if (has_columns) out.set_column(arrays::sensor_x, std::move(x)), out.set_column(arrays::sensor_y, std::move(y));
  return out;
}

PointCloud without_stretch(const PointCloud& points, double stretch, const Run& run) {
  const auto &x = points.values<float>(arrays::sensor_x), &y = points.values<float>(arrays::sensor_y);
  auto positions = points.positions();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1 << 16), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) {
      const Eigen::Vector2f reach = positions[i].template head<2>() - Eigen::Vector2f(x[i], y[i]);
      if (reach.allFinite()) positions[i].template head<2>() -= static_cast<float>(stretch) * reach;
    }
  });
  run.check_cancel();
  PointCloud out = points;
  out.set_positions(std::move(positions));
  return out;
}

Raster lengthened(Raster dem, const WalkStretch& walk) {
  dem.origin += walk.share * (dem.origin - walk.still);
  dem.cell_m *= 1 + walk.share;
  return dem;
}

void tell_range_stretch(double stretch, double taken_out, bool lengthened, Report& report) {
  report.metrics["range_stretch"] = {100 * stretch, Unit::percent};
  if (taken_out == 0) return;
  const bool is_short = taken_out > 0;
  if (!lengthened) {
    report.find(Severity::look, is_short ? "walk_too_short" : "walk_too_long",
                fmt::format("points lie {:.2f} % of their range too {} their sensor: stems lie at other places when "
                            "they are seen from far than from near. Diameters are corrected for it. Where the walk is "
                            "at fault and not the ranges, distances between stems are wrong by as much: compare with "
                            "control points",
                            100 * std::abs(taken_out), is_short ? "far from" : "near to"));
    return;
  }
  report.find(
      Severity::look, is_short ? "walk_too_short" : "walk_too_long",
      fmt::format("the walk is {:.2f} % too {} in the map: stems lie at other places when they are seen from far "
                  "than from near. Cloud and stems were made to fit the ranges; the trajectory, the terrain and the "
                  "targets stay as they were. Run SLAM with another preset, or compare with control points",
                  100 * std::abs(taken_out), is_short ? "short" : "long"));
}

}  // namespace bole::stems
