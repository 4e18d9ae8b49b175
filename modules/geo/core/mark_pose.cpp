#include "geo/core/mark_pose.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace bole::geo {
namespace {

constexpr int max_mark_steps = 30;
constexpr int unknowns = 6;  // x, y, z, yaw, tilt about x, tilt about y

using Normal = Eigen::Matrix<double, unknowns, unknowns>;
using Unknowns = Eigen::Matrix<double, unknowns, 1>;
using Jacobian = Eigen::Matrix<double, 3, unknowns>;

struct State {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // from the first mark
  double yaw_rad = 0;
  Eigen::Vector2d tilt_rad = Eigen::Vector2d::Zero();
  Eigen::Matrix3d R() const {
    return (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(tilt_rad.x(), Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(tilt_rad.y(), Eigen::Vector3d::UnitY()))
        .toRotationMatrix();
  }
};

class MarkAdjustment {
 public:
  MarkAdjustment(const std::vector<SeenMark>& marks, const MarkErrors& errors) : marks_(marks), errors_(errors) {
    origin_ = marks.front().mark_nav;
  }

  const Eigen::Vector3d& origin() const { return origin_; }

  // From the plan alone: the turn between the vectors from the middle of the marks.
  State start() const {
    Eigen::Vector3d seen = Eigen::Vector3d::Zero(), known = Eigen::Vector3d::Zero();
    for (const auto& m : marks_) {
      seen += m.seen / static_cast<double>(marks_.size());
      known += (m.mark_nav - origin_) / static_cast<double>(marks_.size());
    }
    double dot = 0, cross = 0;
    for (const auto& m : marks_) {
      const Eigen::Vector2d a = (m.seen - seen).head<2>(), b = (m.mark_nav - origin_ - known).head<2>();
      dot += a.dot(b);
      cross += a.x() * b.y() - a.y() * b.x();
    }
    State s;
    s.yaw_rad = std::atan2(cross, dot);
    s.position = known - s.R() * seen;
    return s;
  }

  // Known - predicted of a mark.
  Eigen::Vector3d residual(const State& s, std::size_t i) const {
    return marks_[i].mark_nav - origin_ - s.position - s.R() * marks_[i].seen;
  }

  double cost(const State& s) const {
    double sum = s.tilt_rad.squaredNorm() / square(errors_.tilt_rad);
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const Eigen::Vector3d r = residual(s, i);
      sum += r.dot(weight(s, i) * r);
    }
    return sum;
  }

  Normal normal(const State& s, Unknowns& right) const {
    Normal N = Normal::Zero();
    right.setZero();
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const Jacobian J = jacobian(s, i);
      const Eigen::Matrix3d W = weight(s, i);
      N += J.transpose() * W * J;
      right += J.transpose() * W * residual(s, i);
    }
    const double prior = 1 / square(errors_.tilt_rad);
    N.diagonal().tail<2>().array() += prior;
    right.tail<2>() -= prior * s.tilt_rad;
    return N;
  }

 private:
  static double square(double v) { return v * v; }

  // Of the predicted place by the unknowns.
  Jacobian jacobian(const State& s, std::size_t i) const {
    const Eigen::Matrix3d R = s.R();
    const Eigen::Vector3d v = R * marks_[i].seen;
    Jacobian J;
    J.leftCols<3>().setIdentity();
    J.col(3) = Eigen::Vector3d::UnitZ().cross(v);
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(s.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    J.col(4) = (turned * Eigen::Vector3d::UnitX()).cross(v);
    J.col(5) = (turned * Eigen::Vector3d::UnitY()).cross(v);  // the tilts are small: their order does not matter
    return J;
  }

  Eigen::Matrix3d weight(const State& s, std::size_t i) const {
    const Eigen::Vector3d v = s.R() * marks_[i].seen;
    const double d2 = v.squaredNorm();
    const Eigen::Matrix3d along = v * v.transpose() / d2;
    Eigen::Matrix3d C =
        square(errors_.range_m) * along + d2 * square(errors_.direction_rad) * (Eigen::Matrix3d::Identity() - along);
    C.diagonal() +=
        Eigen::Vector3d(square(errors_.mark_plan_m), square(errors_.mark_plan_m), square(errors_.mark_height_m));
    return C.inverse();
  }

  const std::vector<SeenMark>& marks_;
  const MarkErrors& errors_;
  Eigen::Vector3d origin_;
};

void check(const std::vector<SeenMark>& marks, const MarkErrors& e) {
  if (marks.size() < 2)
    throw bad_input(fmt::format("a pose from {} marks", marks.size()), "at least 2", "Place another mark");
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (!marks[i].mark_nav.allFinite() || !marks[i].seen.allFinite() || !(marks[i].seen.norm() > 0.01))
      throw bad_input(fmt::format("mark {} has no place, or is seen in the sensor itself", i + 1),
                      "finite coordinates, and a distance from the sensor");
  for (const double sd : {e.mark_plan_m, e.mark_height_m, e.range_m, e.direction_rad, e.tilt_rad})
    if (!(sd > 0) || !std::isfinite(sd))
      throw bad_input(fmt::format("a standard deviation of {}", sd), "positive standard deviations");
}

}  // namespace

MarkPose pose_from_marks(const std::vector<SeenMark>& marks, const MarkErrors& errors) {
  check(marks, errors);
  const MarkAdjustment adjustment(marks, errors);
  State s = adjustment.start();
  Unknowns right;
  Normal N = adjustment.normal(s, right);
  for (int step = 0; step < max_mark_steps; ++step) {
    const Unknowns dx = N.ldlt().solve(right);
    if (!dx.allFinite()) break;
    s.position += dx.head<3>();
    s.yaw_rad += dx[3];
    s.tilt_rad += dx.tail<2>();
    N = adjustment.normal(s, right);
    if (dx.head<3>().norm() < 1e-9 && dx.tail<3>().norm() < 1e-11) break;
  }
  const Eigen::SelfAdjointEigenSolver<Normal> eigen(N);
  if (!(eigen.eigenvalues()[0] > 1e-9 * eigen.eigenvalues()[unknowns - 1]) || !s.position.allFinite())
    throw bad_input("the marks stand above one another and carry no heading", "marks in different directions",
                    "Move one mark aside");
  MarkPose pose;
  pose.position_nav = s.position + adjustment.origin();
  pose.yaw_rad = wrapped(s.yaw_rad);
  const Normal C = N.inverse();
  pose.covariance = C.topLeftCorner<4, 4>();
  for (std::size_t i = 0; i < marks.size(); ++i) pose.residuals_nav_m.push_back(adjustment.residual(s, i));
  pose.redundancy = 3 * static_cast<int>(marks.size()) + 2 - unknowns;
  pose.sigma0 = std::sqrt(adjustment.cost(s) / pose.redundancy);
  return pose;
}

double largest_usual_sigma0(int redundancy) {
  return std::sqrt(boost::math::quantile(boost::math::chi_squared(redundancy), 0.999) / redundancy);
}

}  // namespace bole::geo
