#include "cloud/first_sight.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angles.h"
#include "base/transform.h"
#include "cloud/core/sight/cell_heights.h"
#include "cloud/core/sight/sample.h"
#include "cloud/core/sight/seen_stems.h"
#include "cloud/core/sight/upright_axis.h"
#include "cloud/robust_mean.h"
#include "cloud/stem_axes.h"

namespace bole {
inline namespace cloud {
namespace {

using namespace sight;

constexpr std::size_t min_points = 100;

// One stem, and nothing beside its foot.
bool is_single_tree(const std::vector<Eigen::Vector3f>& points) {
  const auto z = coordinates(points, 2);
  const float bottom = quantile(z, 0.001), top = quantile(z, 0.999);
  constexpr float foot_m = 0.3F, trunk_from_m = 0.5F, trunk_to_m = 2.0F;
  if (top - bottom < trunk_to_m) return false;
  std::vector<Eigen::Vector3f> foot, trunk;
  for (const auto& p : points) {
    if (p.z() < bottom + foot_m) foot.push_back(p);
    if (p.z() > bottom + trunk_from_m && p.z() < bottom + trunk_to_m) trunk.push_back(p);
  }
  constexpr std::size_t min_foot = 10, min_trunk = 30;
  if (foot.size() < min_foot || trunk.size() < min_trunk) return false;
  constexpr double outside = 0.05;
  constexpr float max_foot_m = 1.2F, max_trunk_m = 2.5F;
  Eigen::Vector2f middle;
  for (int axis = 0; axis < 2; ++axis) {
    const auto range = range_of(coordinates(foot, axis), outside);
    if (range.width() > max_foot_m) return false;
    middle[axis] = 0.5F * (range.low + range.high);
  }
  const auto at_foot = std::ranges::count_if(trunk, [&](const Eigen::Vector3f& p) {
    return (p.head<2>() - middle).cwiseAbs().maxCoeff() < 0.5F * max_trunk_m;
  });
  constexpr double min_share = 0.75;
  return static_cast<double>(at_foot) > min_share * static_cast<double>(trunk.size());
}

void see_lean(const std::vector<StemAxis>& axes, FirstSight& out) {
  constexpr std::size_t min_stems = 5;
  if (axes.size() < min_stems) return;
  std::vector<Eigen::VectorXd> samples;
  std::vector<double> weights;
  for (const auto& a : axes) {
    samples.emplace_back(a.direction.head<2>() / a.direction.z());
    weights.push_back(std::min(a.length_m, 6.0));
  }
  const auto mean = robust_mean(samples, weights, radians(0.2));
  out.stem_direction = Eigen::Vector3d(mean.mean(0), mean.mean(1), 1).normalized();
  out.lean_deg = degrees(std::atan(mean.mean.norm()));
  out.lean_error_deg = degrees(mean.standard_error);
}

void see_heights(const Sample& sample, const CellHeights& cells, FirstSight& out) {
  std::vector<float> heights;
  heights.reserve(sample.points.size());
  std::size_t at_breast_height = 0;
  for (const auto& p : sample.points) {
    const float h = p.z() - cells.low_around(p.x(), p.y(), 1);
    heights.push_back(h);
    if (h > 1.2F && h < 1.4F) ++at_breast_height;
  }
  out.top_height_m = static_cast<double>(quantile(std::move(heights), 0.999));
  out.points_per_m2 = sample.each * static_cast<double>(sample.points.size()) / cells.area_m2();
  out.breast_height_points_per_m2 = sample.each * static_cast<double>(at_breast_height) / cells.area_m2();
}

CloudKind kind_of(const FirstSight& sight) {
  constexpr double sparse_per_m2 = 100, wide_m = 30, low_m = 2;
  if (sight.stems > 0) return CloudKind::plot;
  if (sight.points_per_m2 > sparse_per_m2 && sight.top_height_m > low_m) return CloudKind::plot;
  return sight.extent_m.head<2>().minCoeff() > wide_m ? CloudKind::airborne : CloudKind::unknown;
}

}  // namespace

FirstSight first_sight(const PointCloud& cloud, const Run& run) {
  FirstSight out;
  out.points = cloud.size();
  if (cloud.size() < min_points) return out;
  run.report(0.0, "Looking at the cloud");
  auto sample = sample_of(cloud);
  if (sample.points.size() < min_points) return out;
  for (int axis = 0; axis < 3; ++axis)
    out.extent_m[axis] = static_cast<double>(range_of(coordinates(sample.points, axis), 0.002).width());
  out.duplicated_share = duplicated_share(cloud);
  run.check_cancel();

  auto thin = thinned(cloud, run);
  tbb::parallel_for(
      0, 3, [&](int axis) { out.along[static_cast<std::size_t>(axis)] = evidence_for(thin, sample, axis, run); });
  run.report(0.6, "Looking at the cloud");
  out.up = upright_axis(out.along);
  if (out.up && *out.up != 2) {
    for (auto& p : sample.points) p = z_up(p, *out.up);
    for (auto& p : thin) p = z_up(p.cast<float>(), *out.up).cast<double>();
  }

  constexpr double max_lean_deg = 25;
  const auto axes = find_stem_axes(thin, Eigen::Vector3d::UnitZ(), radians(max_lean_deg), run);
  const CellHeights cells(sample.points, cell_size_m(sample.points, 2));
  see_heights(sample, cells, out);
  const bool single_tree = is_single_tree(sample.points);
  std::optional<double> ground_z;
  if (single_tree) ground_z = static_cast<double>(quantile(coordinates(sample.points, 2), 0.001));
  see_stems(axes, sample, cells, ground_z, out);
  see_lean(axes, out);
  out.kind = single_tree ? CloudKind::single_tree : kind_of(out);
  run.report(1.0, "Looking at the cloud");
  return out;
}

}  // namespace cloud
}  // namespace bole
