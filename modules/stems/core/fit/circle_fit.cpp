#include "stems/core/fit/circle_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/statistics.h"

namespace bole::stems {

double upper_median_near(std::span<double> values, double guess) {
  const double low = 0.65 * guess, high = 1.15 * guess;  // scales of fits shrink from step to step
  std::vector<double> near(values.size());
  std::size_t below = 0, n = 0;
  for (const double v : values) {
    near[n] = v;
    n += v >= low && v < high, below += v < low;
  }
  const std::size_t middle = values.size() / 2;
  if (middle < below || middle >= below + n) return upper_median(values);
  const auto at = near.begin() + static_cast<std::ptrdiff_t>(middle - below);
  std::nth_element(near.begin(), at, near.begin() + static_cast<std::ptrdiff_t>(n));
  return *at;
}

double tukey_weight(double scaled_residual) {
  const double u = scaled_residual / 4.685;
  return std::abs(u) >= 1 ? 0 : (1 - u * u) * (1 - u * u);
}

namespace {

constexpr int arc_sectors = 36;

std::array<bool, arc_sectors> sectors_seen(const std::vector<double>& angles_rad) {
  std::array<bool, arc_sectors> seen{};
  for (const double a : angles_rad)
    seen[static_cast<std::size_t>(static_cast<int>(std::floor((a / (2 * std::numbers::pi) + 1) * arc_sectors)) %
                                  arc_sectors)] = true;
  return seen;
}

}  // namespace

double covered_arc_rad(const std::vector<double>& angles_rad) {
  return 2 * std::numbers::pi * static_cast<double>(std::ranges::count(sectors_seen(angles_rad), true)) / arc_sectors;
}

double unbroken_arc_rad(const std::vector<double>& angles_rad) {
  const auto seen = sectors_seen(angles_rad);
  int longest = 0, run = 0, empty = 0;
  for (std::size_t i = 0; i < 2 * arc_sectors; ++i) {  // twice round, for the run across the start
    if (seen[i % arc_sectors]) {
      run += 1 + (run > 0 ? empty : 0), empty = 0;
    } else if (++empty > 1) {
      run = 0;
    }
    longest = std::max(longest, run);
  }
  return 2 * std::numbers::pi * std::min(longest, arc_sectors) / arc_sectors;
}

std::optional<Circle> hyper_circle(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights) {
  if (points.size() < 3) return std::nullopt;
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  double sum = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += weight(i), mean += weight(i) * points[i];
  if (!(sum > 0)) return std::nullopt;
  mean /= sum;
  double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = points[i] - mean;
    const double z = p.squaredNorm(), w = weight(i) / sum;
    xx += w * p.x() * p.x(), yy += w * p.y() * p.y(), xy += w * p.x() * p.y();
    xz += w * p.x() * z, yz += w * p.y() * z, zz += w * z * z;
  }
  // Newton's method from zero on the characteristic polynomial of the pencil.
  const double z = xx + yy, det_xy = xx * yy - xy * xy, var_z = zz - z * z;
  const double a2 = 4 * det_xy - 3 * z * z - zz;
  const double a1 = var_z * z + 4 * det_xy * z - xz * xz - yz * yz;
  const double a0 = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - var_z * det_xy;
  double eta = 0, value = a0;
  for (int i = 0; i < 50; ++i) {
    const double slope = a1 + eta * (2 * a2 + 16 * eta * eta);
    const double next = eta - value / slope;
    if (!std::isfinite(next) || next == eta) break;
    const double next_value = a0 + next * (a1 + next * (a2 + 4 * next * next));
    if (std::abs(next_value) >= std::abs(value)) break;
    eta = next, value = next_value;
  }
  const double det = eta * eta - eta * z + det_xy;
  const Eigen::Vector2d c(xz * (yy - eta) - yz * xy, yz * (xx - eta) - xz * xy);
  const Eigen::Vector2d centre = c / det / 2;
  const double r2 = centre.squaredNorm() + z - 2 * eta;
  if (!centre.allFinite() || !(r2 > 0) || std::abs(det) < 1e-14 * z * z) return std::nullopt;
  return Circle{centre + mean, std::sqrt(r2)};
}

namespace {

// Four points at a time.
using Lanes = Eigen::Array4d;
constexpr std::size_t lanes = 4;

// What a weighted step of the geometric fit sums over the points: w j j^T and w residual j with j = (x, y, -1).
struct CircleSums {
  Lanes xx = Lanes::Zero(), xy = xx, yy = xx, x = xx, y = xx, w = xx, ex = xx, ey = xx, e = xx;

  Eigen::Matrix3d normal() const {
    Eigen::Matrix3d n;
    n << xx.sum(), xy.sum(), -x.sum(), xy.sum(), yy.sum(), -y.sum(), -x.sum(), -y.sum(), w.sum();
    return n;
  }
  Eigen::Vector3d rhs() const { return {-ex.sum(), -ey.sum(), e.sum()}; }
};

// The points of a circle fit and their distances from its present centre, by coordinate.
class Ring {
 public:
  Ring(const std::vector<Eigen::Vector2d>& points, const Circle& circle) : size_(points.size()) {
    constexpr double far_away_m = 1e6;  // what fills the last lanes has no weight
    const std::size_t filled = (size_ + lanes - 1) / lanes * lanes;
    x_.reserve(filled), y_.reserve(filled);
    for (const auto& p : points) x_.push_back(p.x()), y_.push_back(p.y());
    x_.resize(filled, circle.centre.x() + far_away_m), y_.resize(filled, circle.centre.y());
    distance_.resize(filled);
    look_from(circle.centre);
  }

  void look_from(const Eigen::Vector2d& centre) {
    for (std::size_t i = 0; i < x_.size(); i += lanes)
      Eigen::Map<Lanes>(distance_.data() + i) =
          ((at(x_, i) - centre.x()).square() + (at(y_, i) - centre.y()).square()).sqrt();
  }

  // One weighted Gauss-Newton step of the geometric fit from the circle looked from last; false when the geometry is
  // degenerate.
  bool improve(double scale, Circle& circle) {
    const CircleSums sums = sums_at(scale, circle);
    Eigen::Matrix3d normal = sums.normal();
    normal.diagonal().array() += 1e-9 * normal.trace();
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || !(normal.trace() > 0)) return false;
    Eigen::Vector3d step = solver.solve(sums.rhs());
    if (!step.allFinite()) return false;
    const double longest = 0.5 * circle.radius + 0.01;
    if (step.norm() > longest) step *= longest / step.norm();
    circle.centre += step.head<2>(), circle.radius += step.z();
    look_from(circle.centre);
    return circle.radius > 0;
  }

  double robust_scale(const Circle& circle, double reach) {
    errors_.clear();
    for (std::size_t i = 0; i < size_; ++i)
      if (const double e = std::abs(distance_[i] - circle.radius); e < reach) errors_.push_back(e);
    middle_ = upper_median_near(errors_, middle_);
    return 1.4826 * middle_;
  }

 private:
  static Eigen::Map<const Lanes> at(const std::vector<double>& v, std::size_t i) {
    return Eigen::Map<const Lanes>(v.data() + i);
  }

  CircleSums sums_at(double scale, const Circle& circle) const {
    constexpr double centre_m = 1e-6;  // nearer to it there is no direction
    constexpr double steep = 1e12;     // times a difference and held between 0 and 1: whether it is positive
    const double by_cut = 1 / (4.685 * scale);
    CircleSums s;
    for (std::size_t i = 0; i < x_.size(); i += lanes) {
      const Lanes distance = at(distance_, i), error = distance - circle.radius,
                  rest = (1 - (error * by_cut).square()).max(0.0);
      const Lanes w = ((distance - centre_m) * steep).max(0.0).min(1.0) * rest.square();
      const Lanes by_distance = 1 / distance.max(centre_m), x = (circle.centre.x() - at(x_, i)) * by_distance,
                  y = (circle.centre.y() - at(y_, i)) * by_distance, wx = w * x, wy = w * y, we = w * error;
      s.xx += wx * x, s.xy += wx * y, s.yy += wy * y, s.x += wx, s.y += wy, s.w += w;
      s.ex += we * x, s.ey += we * y, s.e += we;
    }
    return s;
  }

  std::size_t size_;
  std::vector<double> x_, y_, distance_, errors_;
  double middle_ = 0;  // of the errors, when last looked at
};

}  // namespace

bool is_on(const Eigen::Vector2d& point, const RobustCircle& fit) {
  return std::abs((point - fit.circle.centre).norm() - fit.circle.radius) <= 2.5 * fit.sigma;
}

std::optional<RobustCircle> robust_circle(const std::vector<Eigen::Vector2d>& points, const Circle& start,
                                          double start_error_m, double max_sigma) {
  if (points.size() < 5 || !(start.radius > 0)) return std::nullopt;
  RobustCircle fit{start, 0, 0, 0};
  Ring ring(points, start);
  constexpr double smallest_sigma = 0.001;
  double scale = std::max(start_error_m, max_sigma) / 2;
  for (int i = 0; i < 25; ++i) {
    const Circle before = fit.circle;
    const double scale_before = scale;
    if (!ring.improve(scale, fit.circle)) return std::nullopt;
    const double found = ring.robust_scale(fit.circle, 4.685 * scale);
    if (!std::isfinite(found)) return std::nullopt;
    scale = std::clamp(std::max(found, 0.7 * scale), smallest_sigma, std::max(max_sigma, 0.7 * scale));
    constexpr double settled_m = 1e-6;
    if ((fit.circle.centre - before.centre).norm() + std::abs(fit.circle.radius - before.radius) < settled_m &&
        std::abs(scale - scale_before) < settled_m)
      break;
  }
  fit.sigma = scale;
  std::vector<double> angles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_on(points[i], fit)) continue;
    const Eigen::Vector2d d = points[i] - fit.circle.centre;
    ++fit.inliers, angles.push_back(std::atan2(d.y(), d.x()));
  }
  fit.arc_rad = covered_arc_rad(angles);
  if ((fit.circle.centre - start.centre).norm() > 2 * start_error_m + 0.5 * start.radius) return std::nullopt;
  return fit;
}

}  // namespace bole::stems
