#include "geo/core/resection.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace bole::geo {
namespace {

constexpr int max_range_steps = 100;
constexpr double min_spread = 0.02;  // of the marks across, over along: flatter counts as a line or plane
constexpr double misfit_limit = 5;   // sigmas of a range, where there is redundancy to tell

struct Solution {
  Eigen::Vector3d position;
  Eigen::MatrixXd jacobian;   // weighted
  Eigen::VectorXd residuals;  // weighted: (measured - predicted) / sigma
  double cost() const { return residuals.squaredNorm(); }
};

std::string text(const Eigen::Vector3d& p) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x(), p.y(), p.z()); }

class RangeAdjustment {
 public:
  RangeAdjustment(const std::vector<RangeToMark>& ranges, const ResectionOptions& options)
      : ranges_(ranges), options_(options), unknowns_(options.height_m ? 2 : 3) {}

  int unknowns() const { return unknowns_; }

  Solution at(const Eigen::Vector3d& p) const {
    const auto n = static_cast<Eigen::Index>(ranges_.size());
    Solution s{p, Eigen::MatrixXd(n, unknowns_), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& r = ranges_[static_cast<std::size_t>(i)];
      const Eigen::Vector3d d = p - r.mark_nav;
      const double length = std::max(d.norm(), 1e-9);
      s.jacobian.row(i) = d.head(unknowns_).transpose() / length / r.sigma_m;
      s.residuals[i] = (r.range_m - length) / r.sigma_m;
    }
    return s;
  }

  // Levenberg-Marquardt from `start`.
  Solution solve(Eigen::Vector3d start) const {
    if (options_.height_m) start.z() = *options_.height_m;
    Solution best = at(start);
    double damping = 1e-3;
    for (int step = 0; step < max_range_steps; ++step) {
      const Eigen::MatrixXd normal = best.jacobian.transpose() * best.jacobian;
      Eigen::MatrixXd damped = normal;
      damped.diagonal().array() += damping * normal.trace() / unknowns_;
      const Eigen::VectorXd dx = damped.ldlt().solve(best.jacobian.transpose() * best.residuals);
      Eigen::Vector3d next = best.position;
      next.head(unknowns_) += dx;
      Solution candidate = at(next);
      if (candidate.cost() < best.cost()) {
        best = std::move(candidate);
        damping = std::max(damping / 10, 1e-12);
        if (dx.norm() < 1e-12) break;
      } else if ((damping *= 10) > 1e12) {
        break;
      }
    }
    return best;
  }

 private:
  const std::vector<RangeToMark>& ranges_;
  const ResectionOptions& options_;
  int unknowns_;
};

// Centre and axes of the marks, longest first; `extent` are the singular values.
struct Spread {
  Eigen::Vector3d centre;
  Eigen::Matrix3d axes;
  Eigen::Vector3d extent;
};

Spread spread_of(const std::vector<RangeToMark>& ranges, bool horizontal) {
  Eigen::MatrixXd m(ranges.size(), 3);
  for (std::size_t i = 0; i < ranges.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = ranges[i].mark_nav.transpose();
  if (horizontal) m.col(2).setZero();
  const Eigen::RowVector3d centre = m.colwise().mean();
  m.rowwise() -= centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m.transpose() * m);
  return {centre.transpose(), eigen.eigenvectors().rowwise().reverse(),
          eigen.eigenvalues().reverse().cwiseMax(0).cwiseSqrt()};
}

void check_ranges(const std::vector<RangeToMark>& ranges) {
  if (ranges.size() < 3) throw bad_input(fmt::format("a resection from {} ranges", ranges.size()), "at least 3 marks");
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto& r = ranges[i];
    if (!r.mark_nav.allFinite() || !std::isfinite(r.range_m) || !(r.range_m > 0) || !(r.sigma_m > 0) ||
        !std::isfinite(r.sigma_m))
      throw bad_input(
          fmt::format("mark {} has position {}, range {} m, sigma {} m", i + 1, text(r.mark_nav), r.range_m, r.sigma_m),
          "finite positions, positive ranges and sigmas");
  }
}

// One of the two mirrored solutions, or an error where nothing tells them apart.
Solution choose(Solution a, Solution b, const ResectionOptions& options) {
  constexpr double same_m = 1e-4;
  if ((a.position - b.position).norm() < same_m) return a;
  constexpr double clearly = 25;  // of the weighted square sum: a wrong mirror image misfits by 5 sigma
  if (a.cost() + clearly < b.cost()) return a;
  if (b.cost() + clearly < a.cost()) return b;
  if (!options.near_nav)
    throw bad_input(fmt::format("the ranges fit two positions alike, {} and {}, mirrored in the plane of the marks",
                                text(a.position), text(b.position)),
                    "an approximate position, or marks that are not in one plane");
  return (a.position - *options.near_nav).norm() <= (b.position - *options.near_nav).norm() ? a : b;
}

Eigen::MatrixXd checked_covariance(const Solution& s, const Spread& spread, const ResectionOptions& options) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(s.jacobian.transpose() * s.jacobian);
  const double weakest = eigen.eigenvalues()[0];
  if (!(weakest * options.max_sigma_m * options.max_sigma_m >= 1)) {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    direction.head(s.jacobian.cols()) = eigen.eigenvectors().col(0);
    const bool in_plane = std::abs(direction.dot(spread.axes.col(2))) > 0.7 && s.jacobian.cols() == 3;
    throw bad_input(
        fmt::format("the position has a standard error of {} along {}{}",
                    weakest > 0 ? fmt::format("{:.2f} m", 1 / std::sqrt(weakest)) : std::string("any size"),
                    text(direction),
                    in_plane ? ": the sensor lies in the plane of the marks, or the ranges are too short to meet" : ""),
        fmt::format("at most {:g} m", options.max_sigma_m),
        in_plane ? "Raise a mark, or give the height of the sensor" : "Use marks in other directions");
  }
  return (s.jacobian.transpose() * s.jacobian).inverse();
}

}  // namespace

Resection resect(const std::vector<RangeToMark>& ranges, const ResectionOptions& options) {
  check_ranges(ranges);
  const bool flat = options.height_m.has_value();
  const Spread spread = spread_of(ranges, flat);
  if (!(spread.extent[0] > 1e-6))
    throw bad_input("all marks are at one place", "marks in different directions from the sensor");
  if (spread.extent[1] < min_spread * spread.extent[0])
    throw bad_input("the marks lie on a line: the sensor may be anywhere on a circle about it",
                    "marks that span a triangle", "Move one mark off the line");

  // Both sides of the plane of the marks; with a known height the plane is horizontal and both starts are alike.
  const RangeAdjustment adjustment(ranges, options);
  double reach = 0;
  for (const auto& r : ranges) reach += r.range_m / static_cast<double>(ranges.size());
  Solution best = adjustment.solve(spread.centre + 0.5 * reach * spread.axes.col(2));
  Solution other = adjustment.solve(spread.centre - 0.5 * reach * spread.axes.col(2));
  // A near position of the user's is a start of its own: with few marks the square sum has more than one minimum.
  if (options.near_nav)
    if (Solution hinted = adjustment.solve(*options.near_nav); hinted.cost() < best.cost()) best = std::move(hinted);
  best = choose(std::move(best), std::move(other), options);

  Resection result;
  result.position_nav = best.position;
  const int n = adjustment.unknowns();
  result.covariance.topLeftCorner(n, n) = checked_covariance(best, spread, options);
  result.redundancy = static_cast<int>(ranges.size()) - n;
  double worst = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double w = best.residuals[static_cast<Eigen::Index>(i)];
    result.residuals_m.push_back(w * ranges[i].sigma_m);
    worst = std::max(worst, std::abs(w));
  }
  if (worst > misfit_limit)
    throw bad_input(
        fmt::format("the ranges meet nowhere: the worst is off by {:.1f} times its standard deviation", worst),
        fmt::format("at most {:g}", misfit_limit), "Check which range belongs to which mark");
  if (result.redundancy > 0) result.sigma0 = std::sqrt(best.cost() / result.redundancy);
  return result;
}

Heading heading_from_directions(const std::vector<DirectionPair>& directions, double sigma_m) {
  if (!(sigma_m > 0)) throw bad_input(fmt::format("sigma {} m", sigma_m), "a positive standard deviation");
  double dot = 0, cross = 0, square_sum = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto& [seen, known] = directions[i];
    const double a = seen.norm(), b = known.norm();
    if (!std::isfinite(a + b) || std::abs(a - b) > 6 * sigma_m)
      throw bad_input(fmt::format("direction {} is {:.3f} m long as seen and {:.3f} m as known", i + 1, a, b),
                      fmt::format("lengths that agree to {:.3f} m", 6 * sigma_m), "Was another mark taken?");
    dot += seen.dot(known);
    cross += seen.x() * known.y() - seen.y() * known.x();
    square_sum += a * b;
  }
  if (!(square_sum > sigma_m * sigma_m))
    throw bad_input(fmt::format("a heading from {} directions that are as short as their error", directions.size()),
                    "at least one direction longer than that");
  Heading heading;
  heading.yaw_rad = std::atan2(cross, dot);
  heading.se_rad = sigma_m / std::sqrt(square_sum);
  const Eigen::Rotation2Dd turn(heading.yaw_rad);
  for (const auto& [seen, known] : directions) {
    const Eigen::Vector2d turned = turn * seen;
    heading.worst_residual_rad =
        std::max(heading.worst_residual_rad,
                 std::abs(std::atan2(turned.x() * known.y() - turned.y() * known.x(), turned.dot(known))));
  }
  return heading;
}

}  // namespace bole::geo
