#include "base/transform.h"

#include <cmath>

namespace bole {
inline namespace base {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Eigen::Quaterniond so3_exp(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const double half = 0.5 * angle;
  // sin(a/2)/a by its series near zero, where the quotient loses all digits.
  const double k = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  return Eigen::Quaterniond(std::cos(half), k * w.x(), k * w.y(), k * w.z()).normalized();
}

Eigen::Vector3d so3_log(const Eigen::Quaterniond& q_in) {
  const Eigen::Quaterniond q = q_in.w() < 0 ? Eigen::Quaterniond(-q_in.coeffs()) : q_in;
  const double s = q.vec().norm();
  if (s < 1e-9) return 2.0 * q.vec();
  return (2.0 * std::atan2(s, q.w()) / s) * q.vec();
}

namespace {

Eigen::Matrix3d left_jacobian(const Eigen::Vector3d& w) {
  const double a = w.norm();
  const Eigen::Matrix3d W = skew(w);
  if (a < 1e-6) return Eigen::Matrix3d::Identity() + 0.5 * W + W * W / 6.0;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(a)) / (a * a) * W + (a - std::sin(a)) / (a * a * a) * W * W;
}

}  // namespace

Pose se3_exp(const Vector6d& twist) {
  Pose T = Pose::Identity();
  T.linear() = so3_exp(twist.head<3>()).toRotationMatrix();
  T.translation() = left_jacobian(twist.head<3>()) * twist.tail<3>();
  return T;
}

Vector6d se3_log(const Pose& T) {
  Vector6d twist;
  twist.head<3>() = so3_log(Eigen::Quaterniond(T.linear()));
  twist.tail<3>() = left_jacobian(twist.head<3>()).inverse() * T.translation();
  return twist;
}

Pose interpolate(const Pose& a, const Pose& b, double s) {
  const Eigen::Quaterniond qa(a.linear()), qb(b.linear());
  Pose T = Pose::Identity();
  T.linear() = (qa * so3_exp(s * so3_log(qa.conjugate() * qb))).toRotationMatrix();
  T.translation() = a.translation() + s * (b.translation() - a.translation());
  return T;
}

Eigen::Matrix3d rotation_from_rpy(double roll, double pitch, double yaw) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return (AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) *
          AngleAxisd(roll, Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

}  // namespace base
}  // namespace bole
