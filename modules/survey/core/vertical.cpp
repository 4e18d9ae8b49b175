#include "survey/core/vertical.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "base/transform.h"
#include "cloud/known_facts.h"
#include "cloud/robust_mean.h"
#include "cloud/stem_axes.h"
#include "survey/core/ground_plane.h"

namespace bole::survey {
namespace {

struct MeanDirection {
  Eigen::Vector3d direction;
  RobustMean spread;
};

// Robust mean of unit vectors near `about`, on the tangent plane there.
MeanDirection mean_direction(const std::vector<StemAxis>& axes, const Eigen::Vector3d& about) {
  const Eigen::Matrix3d R = rotation_between(about, Eigen::Vector3d::UnitZ());
  std::vector<Eigen::VectorXd> samples;
  std::vector<double> weights;
  for (const auto& a : axes) {
    const Eigen::Vector3d d = R * a.direction;
    samples.emplace_back(d.head<2>() / d.z());
    weights.push_back(std::min(a.length_m, 6.0));
  }
  constexpr double min_sigma_rad = 0.2 * rad_per_deg;
  MeanDirection out;
  out.spread = robust_mean(samples, weights, min_sigma_rad);
  out.direction = R.transpose() * Eigen::Vector3d(out.spread.mean(0), out.spread.mean(1), 1.0).normalized();
  return out;
}

bool level_by_stems(const PointCloud& cloud, const FrameOptions& options, const Run& run, Vertical& vertical) {
  const auto points = thinned(cloud, run);
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double search_rad = options.max_tilt_deg * rad_per_deg;
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    const auto axes = find_stem_axes(points, up, search_rad, run);
    vertical.stems = axes.size();
    if (axes.size() < static_cast<std::size_t>(options.min_stems)) return false;
    const auto mean = mean_direction(axes, up);
    const double step = std::acos(std::clamp(up.dot(mean.direction), -1.0, 1.0));
    up = mean.direction;
    vertical.standard_error_rad = mean.spread.standard_error;
    vertical.scatter_rad = mean.spread.sigma;
    search_rad = std::min(search_rad, 12.0 * rad_per_deg);
    if (round > 0 && step < 0.01 * rad_per_deg) break;
  }
  vertical.up = up, vertical.method = Level::stems;
  return true;
}

bool level_by_ground(const PointCloud& cloud, const FrameOptions& options, const Run& run, Vertical& vertical) {
  const auto plane = lowest_plane(cloud, run);
  if (!plane.valid) return false;
  const double tilt = std::acos(plane.normal.z());
  if (tilt > options.max_tilt_deg * rad_per_deg) {
    vertical.warnings.push_back(
        fmt::format("the ground is tilted by {:.1f} deg against the map's z axis, more than max_tilt ({} deg): "
                    "the map was not levelled",
                    tilt / rad_per_deg, number_text(options.max_tilt_deg)));
    return false;
  }
  vertical.up = plane.normal, vertical.method = Level::ground;
  vertical.standard_error_rad = std::numeric_limits<double>::quiet_NaN();
  vertical.warnings.push_back(
      "levelled by the plane of the ground: the slope of the plot cannot be separated from the tilt of the map and was "
      "removed with it");
  return true;
}

}  // namespace

Vertical find_vertical(const PointCloud& cloud, const FrameOptions& options, const Run& run) {
  constexpr double max_gravity_sigma_deg = 0.3;  // stems are as good or better beyond it
  Vertical vertical;
  if (options.level == Level::none) return vertical;
  const auto sigma_deg = fact_number(cloud.facts, facts::level_sigma);
  if (options.level == Level::gravity && !sigma_deg)
    throw bad_input("level is gravity, and nothing tells the direction of gravity in this map",
                    "a map that was made with an inertial unit (slam.preset best or inertial)",
                    "Set level to stems, or to auto");
  if (sigma_deg &&
      (options.level == Level::gravity || (options.level == Level::automatic && *sigma_deg <= max_gravity_sigma_deg))) {
    vertical.method = Level::gravity;
    vertical.standard_error_rad = radians(*sigma_deg);
    return vertical;
  }
  if (options.level == Level::stems || options.level == Level::automatic) {
    if (level_by_stems(cloud, options, run, vertical)) return vertical;
    vertical.warnings.push_back(
        fmt::format("{} stems were found to level by, min_stems is {}: the ground was taken instead", vertical.stems,
                    options.min_stems));
  }
  if (!level_by_ground(cloud, options, run, vertical))
    vertical.warnings.push_back("there was nothing to level by: the map's z axis was kept");
  return vertical;
}

}  // namespace bole::survey
