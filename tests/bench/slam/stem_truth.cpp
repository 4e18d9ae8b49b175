#include "stem_truth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "slam/core/odometry/motion.h"

namespace bole {
namespace {

constexpr double half_slice_m = 0.3, most_residual_m = 0.12, most_impact = 0.9;
constexpr std::size_t views = 12, least_returns = 40;

double median(std::vector<double> v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

std::optional<StemReturn> hit(const TrueStem& stem, const Eigen::Vector3d& sensor, const Eigen::Vector3d& point) {
  const Eigen::Vector3d o = point - stem.breast_height;
  const double h = o.dot(stem.axis);
  if (std::abs(h) > half_slice_m) return std::nullopt;
  // Axes across the stem.
  const Eigen::Vector3d e1 = stem.axis.cross(Eigen::Vector3d::UnitY()).normalized(), e2 = stem.axis.cross(e1);
  const Eigen::Vector3d s = sensor - stem.breast_height, ray = point - sensor;
  const Eigen::Vector2d place(o.dot(e1), o.dot(e2)), from(s.dot(e1), s.dot(e2)),
      across = Eigen::Vector2d(ray.dot(e1), ray.dot(e2)).normalized();
  const double impact_m = from.x() * across.y() - from.y() * across.x();
  if (std::abs(impact_m) > most_impact * stem.radius) return std::nullopt;
  const double steepness = (point - sensor).norm() / (place - from).norm(),
               expected_m = -from.dot(across) - std::sqrt(stem.radius * stem.radius - impact_m * impact_m);
  const double along_m = steepness * ((place - from).norm() - expected_m);
  if (std::abs(along_m) > most_residual_m) return std::nullopt;
  return StemReturn{0, along_m, ray.norm(), impact_m / stem.radius, place, across};
}

std::size_t view_of(const Eigen::Vector2d& ray) {
  const double turn = 0.5 + std::atan2(ray.y(), ray.x()) / (2 * std::numbers::pi);
  return std::min(views - 1, static_cast<std::size_t>(turn * views));
}

// The shift of the centre that the residuals along the rays ask for, with their mean left free, by Tukey weights.
Eigen::Vector3d own_shift(const std::vector<const StemReturn*>& returns) {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix3d H = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for (const auto* r : returns) {
      const Eigen::Vector3d J(r->ray.x(), r->ray.y(), 1);
      const double e = r->along_m - J.dot(x), u = e / 0.06, w = std::abs(u) < 1 ? std::pow(1 - u * u, 2) : 0;
      H += w * J * J.transpose();
      g += w * e * J;
    }
    x += H.ldlt().solve(g);
  }
  return x;
}

}  // namespace

std::vector<TrueStem> true_stems(const Table& trees) {
  const auto x = trees.numbers("x_m"), y = trees.numbers("y_m"), z = trees.numbers("z_m"),
             dbh = trees.numbers("dbh_cm"), inside = trees.numbers("in_plot"), bx = trees.numbers("base_x_m"),
             by = trees.numbers("base_y_m");
  std::vector<TrueStem> out;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (inside[i] > 0)
      out.push_back(
          {{x[i], y[i], z[i] + 1.3}, Eigen::Vector3d(x[i] - bx[i], y[i] - by[i], 1.3).normalized(), dbh[i] / 200});
  return out;
}

std::vector<StemReturn> stem_returns(const FrameSource& source, std::size_t frames, const PoseInPlot& pose,
                                     const std::vector<TrueStem>& stems) {
  std::vector<StemReturn> out;
  ScanFrame frame;
  for (std::size_t k = 0; k < std::min(frames, source.size()); ++k) {
    source.read(k, frame);
    const double span_s = frame.end_time_s - frame.start_time_s;
    if (!pose(frame.start_time_s) || !pose(frame.end_time_s)) continue;
    const slam::PoseGrid poses([&](double s) { return *pose(frame.start_time_s + s * span_s); });
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const float range = frame.positions[i].norm();
      if (!(range > 1 && range < 25)) continue;
      const auto s = static_cast<float>(frame.time_offset_s[i] / span_s);
      const Eigen::Vector3d sensor = poses.translation(s), point = poses.turned(frame.positions[i], s) + sensor;
      for (std::size_t t = 0; t < stems.size(); ++t) {
        if ((point - stems[t].breast_height).squaredNorm() > 1) continue;
        if (auto r = hit(stems[t], sensor, point)) {
          r->stem = t;
          out.push_back(*r);
        }
      }
    }
  }
  return out;
}

WallFigures wall_figures(const std::vector<StemReturn>& returns, std::size_t stems) {
  std::vector<std::vector<const StemReturn*>> of_stem(stems);
  for (const auto& r : returns) of_stem[r.stem].push_back(&r);
  WallFigures out;
  out.wall_of_stem_mm.assign(stems, 0);
  double along = 0, own_along = 0, shift2 = 0, seen_views = 0, seen_stems = 0;
  std::vector<double> walls;
  for (std::size_t t = 0; t < stems; ++t) {
    if (of_stem[t].size() < least_returns) continue;
    const auto shift = own_shift(of_stem[t]);
    std::array<std::vector<double>, views> view;
    std::vector<double> radial;
    for (const auto* r : of_stem[t]) {
      view[view_of(r->ray)].push_back(r->along_m);
      radial.push_back(r->along_m - r->ray.dot(shift.head<2>()));
    }
    for (const auto& v : view)
      if (v.size() >= least_returns) {
        along += median(v);
        seen_views += 1;
      }
    own_along += shift.z();
    shift2 += shift.head<2>().squaredNorm();
    seen_stems += 1;
    const double middle = median(radial);
    for (auto& r : radial) r = std::abs(r - middle);
    walls.push_back(out.wall_of_stem_mm[t] = 1482.6 * median(radial));
  }
  if (walls.empty() || seen_views == 0) return out;
  out.along_mm = 1000 * along / seen_views;
  out.own_along_mm = 1000 * own_along / seen_stems;
  out.own_sd_mm = 1000 * std::sqrt(shift2 / seen_stems);
  out.wall_mm = median(walls);
  return out;
}

}  // namespace bole
