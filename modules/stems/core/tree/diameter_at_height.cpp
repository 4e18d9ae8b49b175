#include "stems/core/tree/diameter_at_height.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/angles.h"
#include "base/statistics.h"
#include "cloud/table_columns.h"
#include "stems/core/detect/ring_density.h"
#include "stems/core/fit/stem_shape.h"
#include "stems/core/stem_options.h"

namespace bole::stems {
namespace {

constexpr double start_error_m = 0.05, min_contrast = 2;  // as of sections near breast height
constexpr std::size_t min_known_cuts = 3;

double or_zero(double v) { return std::isfinite(v) ? v : 0; }

// Sums for the covariance of centre and radius, where residuals within a block may be correlated at will.
class CircleSpread {
 public:
  explicit CircleSpread(const RobustCircle& fit) : fit_(fit) {}

  void add(const Eigen::Vector2d& point, int pass) {
    const Eigen::Vector2d d = point - fit_.circle.centre;
    const double distance = d.norm(), u = (distance - fit_.circle.radius) / (4.685 * fit_.sigma);
    if (std::abs(u) >= 1 || distance <= 0) return;
    const Eigen::Vector3d jacobian(-d.x() / distance, -d.y() / distance, -1);
    const double rest = 1 - u * u;
    normal_ += rest * (1 - 5 * u * u) * jacobian * jacobian.transpose();
    const Eigen::Vector3d g = rest * rest * (distance - fit_.circle.radius) * jacobian;
    const double bearing = std::atan2(d.y(), d.x());
    for (std::size_t k = 0; k < widths_rad.size(); ++k) {
      const auto sector = static_cast<int>(std::floor(bearing / widths_rad[k]));
      blocks_[k].try_emplace({pass, sector}, Eigen::Vector3d::Zero()).first->second += g;
    }
  }

  // Standard deviation of the radius and the number of blocks it rests on.
  std::pair<double, std::size_t> radius() const {
    const Eigen::Matrix3d inverse = normal_.ldlt().solve(Eigen::Matrix3d::Identity());
    // Noise alone leaves at least this unknown.
    double variance = inverse(2, 2) * fit_.sigma * fit_.sigma;
    std::size_t blocks = blocks_[0].size();
    for (const auto& by_sector : blocks_) {
      Eigen::Matrix3d meat = Eigen::Matrix3d::Zero();
      const auto count = static_cast<double>(by_sector.size());
      for (const auto& [key, g] : by_sector) meat += count / std::max(1.0, count - 1) * g * g.transpose();
      if (const double v = (inverse * meat * inverse.transpose())(2, 2); v > variance) {
        variance = v;
        blocks = by_sector.size();
      }
    }
    return {std::sqrt(variance), blocks};
  }

 private:
  static constexpr std::array<double, 2> widths_rad{std::numbers::pi / 18, std::numbers::pi / 6};
  const RobustCircle& fit_;
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  std::array<std::map<std::pair<int, int>, Eigen::Vector3d>, 2> blocks_;
};

bool is_stem(const std::vector<Eigen::Vector2d>& ring, const RobustCircle& fit, double expected_m) {
  const MeasureOptions limits;
  if (fit.inliers < limits.min_section_points || fit.arc_rad < radians(limits.min_arc_deg) - 1e-9) return false;
  if (std::abs(fit.circle.radius - expected_m) > 0.03 + 0.3 * expected_m) return false;
  RingDensity density(fit.circle.radius);
  for (const auto& p : ring) density.add((p - fit.circle.centre).norm() - fit.circle.radius);
  return density.contrast() >= min_contrast;
}

// The plain circle of a cut, in the plane across the axis, and the points that are near it.
struct PlainCircle {
  RobustCircle fit;
  std::vector<Eigen::Vector2d> ring;
  std::vector<int> pass;
};

std::optional<PlainCircle> plain_circle(const std::vector<CutPoint>& points, double expected_m,
                                        const AcrossAxis& axis) {
  PlainCircle c;
  for (const auto& p : points)
    if (const Eigen::Vector2d q = axis.across(p); std::abs(q.norm() - expected_m) < 2 * start_error_m) {
      c.ring.push_back(q);
      c.pass.push_back(p.pass);
    }
  const auto fit =
      robust_circle(c.ring, {Eigen::Vector2d::Zero(), expected_m}, start_error_m, MeasureOptions().max_sigma);
  if (!fit || !is_stem(c.ring, *fit, expected_m)) return std::nullopt;
  c.fit = *fit;
  return c;
}

}  // namespace

AcrossAxis::AcrossAxis(const Eigen::Vector2d& slope)
    : slope_(slope),
      along_(slope.norm() > 0 ? slope.normalized() : Eigen::Vector2d::UnitX()),
      cosine_(1 / std::sqrt(1 + slope.squaredNorm())) {}

Eigen::Vector2d AcrossAxis::across(const CutPoint& p) const {
  const Eigen::Vector2d q = p.plan - p.above_m * slope_;
  return q + (cosine_ - 1) * along_.dot(q) * along_;
}

Eigen::Vector2d AcrossAxis::plan(const Eigen::Vector2d& across) const {
  return across + (1 / cosine_ - 1) * along_.dot(across) * along_;
}

KnownStem known_stem(const Table& stems, std::size_t row) {
  const auto number = [&](const char* name) { return numbers_or_nan(stems, name)[row]; };
  KnownStem known;
  const double lean = std::tan(radians(or_zero(number("lean_deg")))),
               azimuth = radians(or_zero(number("lean_azimuth_deg")));  // clockwise from north
  known.slope = lean * Eigen::Vector2d(std::sin(azimuth), std::cos(azimuth));
  known.radius_m = or_zero(number("dbh_cm")) / 200;
  // The table counts along the stem.
  known.taper = or_zero(number("taper_cm_per_m")) / 200 * std::sqrt(1 + lean * lean);
  known.radius_half_m = (number("dbh_hi_cm") - number("dbh_lo_cm")) / 400;
  known.arc_rad = radians(or_zero(number("arc_deg")));
  return known;
}

void compare_cuts(const std::vector<StemCut>& near_breast_height, KnownStem& known) {
  if (!std::isfinite(known.radius_half_m)) return;
  const AcrossAxis axis(known.slope);
  std::vector<double> excess_m;
  for (const auto& cut : near_breast_height) {
    const double expected = std::max(0.01, known.radius_m - known.taper * cut.above_breast_m);
    if (const auto c = plain_circle(cut.points, expected, axis)) excess_m.push_back(c->fit.circle.radius - expected);
  }
  known.too_wide_m = excess_m.empty() ? 0 : median(excess_m);
  known.cut_sd_m = 0;
  known.too_wide_sd_m = 0;
  if (excess_m.size() < min_known_cuts) return;
  const auto n = static_cast<double>(excess_m.size());
  double square = 0;
  for (const double e : excess_m) square += (e - known.too_wide_m) * (e - known.too_wide_m);
  known.cut_sd_m = std::sqrt(square / (n - 1));
  constexpr double median_by_mean = 1.253;  // standard error of a median by that of a mean, normal errors
  known.too_wide_sd_m = median_by_mean * known.cut_sd_m / std::sqrt(n);
}

std::optional<DiameterAtHeight> diameter_at_height(const std::vector<CutPoint>& points, double expected_radius_m,
                                                   const KnownStem& known) {
  const AcrossAxis axis(known.slope);
  const auto plain = plain_circle(points, std::max(0.01, expected_radius_m + known.too_wide_m), axis);
  if (!plain) return std::nullopt;
  const auto& fit = plain->fit;
  CircleSpread spread(fit);
  for (std::size_t i = 0; i < plain->ring.size(); ++i) spread.add(plain->ring[i], plain->pass[i]);
  const auto [radius_sd, blocks] = spread.radius();
  DiameterAtHeight d;
  d.circle = {axis.plan(fit.circle.centre), std::max(0.005, fit.circle.radius - known.too_wide_m)};
  d.sigma = fit.sigma;
  d.arc_rad = fit.arc_rad;
  d.inliers = fit.inliers;
  constexpr double circle_unknowns = 3;
  const double own = student_975(std::max(2.0, static_cast<double>(blocks) - circle_unknowns)) *
                     std::hypot(std::max(radius_sd, known.cut_sd_m), known.too_wide_sd_m),
               unseen = z_95 * unseen_shape_sd(d.circle.radius, d.arc_rad);
  // Where plain circles and the joint fit differ, nobody knows that they do so by as much at another height.
  const double half = std::hypot(std::hypot(own, unseen), std::hypot(known.radius_half_m, known.too_wide_m));
  // What brushed the edges makes circles too wide, by more where less is seen: what of it breast height did not tell.
  const double edges = std::max(0.0, unknown_edges_m(d.sigma, d.arc_rad) - unknown_edges_m(d.sigma, known.arc_rad));
  d.radius_low = std::isfinite(half) ? std::max(0.0, d.circle.radius - half - edges) : half;
  d.radius_high = d.circle.radius + half;
  return d;
}

}  // namespace bole::stems
