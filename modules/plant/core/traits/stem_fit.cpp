#include "plant/core/traits/stem_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr double sd_floor_px = 0.06;  // what the model of the edge leaves open in any picture
constexpr double tukey = 4.685;

// Parameters: place x y, lean x y, bow x y, radius, change of the radius per unit of t; and a shift per view.
struct EdgeError {
  Eigen::Vector3d centre, left, right;
  double t, z, unit, pixels, sd_left, sd_right;

  template <class T>
  bool operator()(const T* x, const T* shift, T* residual) const {
    using V = Eigen::Matrix<T, 3, 1>;
    const T u(t);
    const V axis(x[0] + u * (x[2] + u * x[4]), x[1] + u * (x[3] + u * x[5]), T(z));
    const V tangent((x[2] + 2.0 * u * x[4]) / unit, (x[3] + 2.0 * u * x[5]) / unit, T(1));
    const V to_axis = axis - centre.cast<T>();
    const T radius = x[6] + u * x[7];
    // Both normals point to the right of the stem's way up as the camera sees it.
    const V normal_left = tangent.cross(left.cast<T>().eval()).normalized();
    const V normal_right = tangent.cross(right.cast<T>().eval()).normalized();
    const T sign = T(orientation);
    residual[0] = ((sign * to_axis.dot(normal_left) - radius) * pixels + shift[0]) / sd_left;
    residual[1] = ((-sign * to_axis.dot(normal_right) - radius) * pixels - shift[0]) / sd_right;
    return true;
  }
  double orientation = 1;
};

// A shift of a view, held near zero.
struct ShiftPrior {
  double sigma;
  template <class T>
  bool operator()(const T* v, T* r) const {
    r[0] = v[0] / sigma;
    return true;
  }
};

// Bow and taper, held near zero.
struct StraightPrior {
  double bow_sigma, taper_sigma;
  template <class T>
  bool operator()(const T* x, T* r) const {
    r[0] = x[4] / bow_sigma;
    r[1] = x[5] / bow_sigma;
    r[2] = x[7] / taper_sigma;
    return true;
  }
};

// Which sign makes the distance of the axis from the left edge's plane positive.
double orientation_of(const StemStrip& s, const StemCurve& axis) {
  const Eigen::Vector3d t = axis.tangent(s.z);
  return t.cross(s.ray_left).dot(s.ray_right) >= 0 ? 1 : -1;
}

// Diameter that one strip shows where the axis is known.
double diameter_of(const StemStrip& s, const StemCurve& axis) {
  const Eigen::Vector3d t = axis.tangent(s.z);
  const Eigen::Vector3d nl = t.cross(s.ray_left).normalized(), nr = t.cross(s.ray_right).normalized();
  const Eigen::Vector3d d = axis.at(s.z) - s.centre;
  const double distance = (d - d.dot(t) * t).norm();
  const double half_angle = 0.5 * std::atan2(nl.cross(nr).norm(), nl.dot(nr));
  return 2 * distance * std::sin(half_angle);
}

struct Unknowns {
  std::array<double, 8> x{};
  std::map<std::uint32_t, double> shift;

  StemCurve curve(const StemCurve& start) const {
    StemCurve c = start;
    c.place = {x[0], x[1]};
    c.lean = {x[2], x[3]};
    c.bow = {x[4], x[5]};
    return c;
  }
};

void adjust(const std::vector<StemStrip>& strips, const StemCurve& start, double pose_sigma_px, double start_radius,
            Unknowns& unknowns) {
  ceres::Problem problem;
  for (const auto& s : strips) {
    if (s.weight <= 0) continue;
    auto* error = new EdgeError;
    error->centre = s.centre;
    error->left = s.ray_left;
    error->right = s.ray_right;
    error->z = s.z;
    error->t = (s.z - start.height) / start.unit;
    error->unit = start.unit;
    error->pixels = s.pixels_per_unit;
    error->sd_left = std::hypot(s.sd_left, sd_floor_px);
    error->sd_right = std::hypot(s.sd_right, sd_floor_px);
    error->orientation = orientation_of(s, unknowns.curve(start));
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<EdgeError, 2, 8, 1>(error),
                             new ceres::ScaledLoss(new ceres::HuberLoss(2), s.weight, ceres::TAKE_OWNERSHIP),
                             unknowns.x.data(), &unknowns.shift[s.view]);
  }
  for (auto& [view, shift] : unknowns.shift)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ShiftPrior, 1, 1>(new ShiftPrior{pose_sigma_px}), nullptr,
                             &shift);
  // Over a stretch of a few centimetres a stem bends by less than its radius, and tapers by less than a sixth of it.
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<StraightPrior, 3, 8>(new StraightPrior{start_radius, start_radius / 6}), nullptr,
      unknowns.x.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  auto* ordering = new ceres::ParameterBlockOrdering;
  for (auto& [view, shift] : unknowns.shift) ordering->AddElementToGroup(&shift, 0);
  ordering->AddElementToGroup(unknowns.x.data(), 1);
  options.linear_solver_ordering.reset(ordering);
  options.max_num_iterations = 40;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

// Weights by what the fit leaves of the width, and of the place, of each strip.
double reweigh(std::vector<StemStrip>& strips, const StemCurve& axis, const Unknowns& unknowns) {
  std::vector<double> off;
  for (const auto& s : strips) {
    const double t = (s.z - axis.height) / axis.unit;
    off.push_back((diameter_of(s, axis) - 2 * (unknowns.x[6] + t * unknowns.x[7])) * s.pixels_per_unit);
  }
  std::vector<double> sizes;
  for (const double o : off) sizes.push_back(std::abs(o));
  const double scale = std::max(1.4826 * median(std::move(sizes)), 0.08);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const double u = off[i] / (tukey * scale);
    strips[i].weight = std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
  }
  return scale;
}

// What a view's own strips leave open of its diameter. Mottles behind the stem are wider than a pixel and longer than a
// strip is thick: 25 strips say as much as one of independent pixels.
double own_variance(double information) { return 25 / information; }

// The mean over the views, weighted by what the strips of each leave open (before soil of its own colour a stem has
// next to no edges) and what differs from view to view; outliers by Tukey's weights.
void average_views(const std::vector<StemStrip>& strips, const Unknowns& unknowns, StemFit& fit) {
  std::map<std::uint32_t, std::pair<double, double>> sums;  // weight, weighted diameter
  std::map<std::uint32_t, std::size_t> counts;
  for (const auto& s : strips) {
    if (s.weight <= 0) continue;
    const double t = (s.z - fit.axis.height) / fit.axis.unit;
    const double here = diameter_of(s, fit.axis) - 2 * t * unknowns.x[7];
    const double w = s.weight * s.pixels_per_unit * s.pixels_per_unit /
                     (s.sd_left * s.sd_left + s.sd_right * s.sd_right + 2 * sd_floor_px * sd_floor_px);
    sums[s.view].first += w;
    sums[s.view].second += w * here;
    ++counts[s.view];
  }
  std::vector<double> diameters, own;
  for (const auto& [view, sum] : sums) {
    if (counts[view] < 3) continue;
    fit.per_view.push_back({view, sum.second / sum.first, 1, counts[view]});
    diameters.push_back(sum.second / sum.first);
    own.push_back(own_variance(sum.first));
  }
  if (diameters.empty()) return;
  double mean = median(diameters), total = 0, squares = 0, scale = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<double> sizes;
    for (const double d : diameters) sizes.push_back(std::abs(d - mean));
    scale = std::max(1.4826 * median(std::move(sizes)), 1e-4 * mean);
    double sum = 0;
    total = squares = 0;
    const double between = std::max(scale * scale - median(own), 0.04 * scale * scale);
    for (std::size_t i = 0; i < fit.per_view.size(); ++i) {
      auto& v = fit.per_view[i];
      const double u = (v.diameter - mean) / (tukey * scale);
      const double votes = between / (between + own[i]);
      v.weight = std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) * votes : 0;
      sum += v.weight * v.diameter;
      total += v.weight;
      squares += v.weight * v.weight;
    }
    if (!(total > 0)) return;
    mean = sum / total;
  }
  double scatter = 0;
  for (const auto& v : fit.per_view) {
    scatter += v.weight * (v.diameter - mean) * (v.diameter - mean);
    fit.views += v.weight > 0;
  }
  const double effective = total * total / squares;
  // Tukey's weights shrink the scatter; neighbouring views share light, background and pose: two count as one.
  fit.view_scatter = std::max(1.1 * std::sqrt(scatter / total), 0.5 * scale);
  fit.freedom = std::max(1.0, effective / 2 - 1);
  fit.standard_error = fit.view_scatter / std::sqrt(std::max(effective / 2, 1.0));
  fit.diameter = mean;
}

}  // namespace

std::optional<StemFit> fit_stem(std::vector<StemStrip>& strips, const StemCurve& start, double start_radius,
                                double pose_sigma_px, const Run& run) {
  if (strips.size() < 12) return std::nullopt;
  Unknowns unknowns;
  unknowns.x = {start.place.x(), start.place.y(), start.lean.x(), start.lean.y(),
                start.bow.x(),   start.bow.y(),   start_radius,   0};
  for (auto& s : strips) s.weight = 1;
  // The views that agree: widths far from the median are leaves and shadows.
  std::vector<double> widths;
  for (const auto& s : strips) widths.push_back(diameter_of(s, start));
  const double usual = median(widths);
  for (std::size_t i = 0; i < strips.size(); ++i)
    if (widths[i] < 0.7 * usual || widths[i] > 1.45 * usual) strips[i].weight = 0;
  unknowns.x[6] = usual / 2;
  StemFit fit;
  for (int round = 0; round < 6; ++round) {
    run.check_cancel();
    if (std::ranges::count_if(strips, [](const auto& s) { return s.weight > 0; }) < 12) return std::nullopt;
    unknowns.shift.clear();
    for (const auto& s : strips)
      if (s.weight > 0) unknowns.shift[s.view] = 0;
    adjust(strips, start, pose_sigma_px, usual / 2, unknowns);
    fit.axis = unknowns.curve(start);
    fit.residual_px = reweigh(strips, fit.axis, unknowns);
  }
  fit.taper = 2 * unknowns.x[7] / start.unit;
  for (const auto& s : strips) fit.strips += s.weight > 0;
  average_views(strips, unknowns, fit);
  if (fit.views < 3 || !(fit.diameter > 0)) return std::nullopt;
  return fit;
}

}  // namespace bole::plant
