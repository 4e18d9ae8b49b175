// The points of one stem, in the axes of that stem.
#pragma once

#include <vector>

#include "stems/core/fit/fit_stem.h"
#include "stems/core/fit/near_points.h"

namespace bole::stems {

// An axis with a radius that changes along it; offsets from the cloud's origin.
struct AxisLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double radius = 0, taper = 0;  // at `point`; per metre along the axis

  Eigen::Vector3d at_z(double z) const { return point + (z - point.z()) / direction.z() * direction; }
  double radius_at(double z) const { return radius + taper * (z - point.z()) / direction.z(); }
};

// Origin on the axis at breast height, z along the axis: p_stem = rotation * (p - origin).
struct StemAxes {
  StemAxes() = default;
  StemAxes(const Eigen::Vector3d& at, const Eigen::Vector3d& direction, double ground);
  Eigen::Vector3d to_stem(const Eigen::Vector3d& p) const { return rotation * (p - origin); }
  Eigen::Vector3d to_cloud(const Eigen::Vector3d& p) const { return rotation.transpose() * p + origin; }

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double ground_z = 0;
};

// Highest or mean ground on a circle around a stem base, offset z. NaN where the terrain model has a hole.
double ground_around(const Raster& dem, const Eigen::Vector3d& cloud_origin, const Eigen::Vector2d& base, double radius,
                     bool uphill);

struct GatherOptions {
  double radius = 0, taper = 0;
  double lowest = 0, highest = 0;  // along the stem from breast height, metres
  double max_range = 20;
  double beam_divergence = 0;  // full angle across the stem, radians
  double beam_doubt = 0;       // standard deviation of that
  double beam_aperture = 0;    // width of the beam at the sensor, metres
  double blur = 0;             // scatter of the rays across themselves, metres
  double blur_doubt = 0;       // standard deviation of that
  std::size_t max_points = 40000;
};

// Points near the expected surface or inside, sorted by place. Points beyond max_range are left out when nearer
// ones are plenty; of very many an even choice remains. None after a cancel: columns that lie on file are slow to read
// all over.
std::vector<BarkPoint> gather_bark(NearPoints& near, const StemAxes& axes, const GatherOptions& options,
                                   const Run& run);

// Sections thick enough to hold a circle: `step_m`, doubled up to four times its size while most of the sections have
// fewer than `least` points.
double section_step(const std::vector<BarkPoint>& points, double step_m, int least);
void number_sections(std::vector<BarkPoint>& points, double step_m);

// Gives every point its pass, from 0, by pauses in time, and by the passes of the cloud too where `by_cloud` or where
// times are not known; the number of passes. One when neither is known.
int number_passes(std::vector<BarkPoint>& points, const CloudRays& rays, double gap_s, bool by_cloud);

}  // namespace bole::stems
