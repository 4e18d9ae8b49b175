#include "rgbd/core/poses/pose_uncertainty.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace bole::rgbd {
namespace {

constexpr std::size_t max_matrix_views = 300;  // the matrix has 36 numbers for each pair of views
constexpr double fixed_weight = 1e12;
constexpr double point_damping = 1e-9;  // relative: points that nothing but one depth holds

using Jacobian = Eigen::Matrix<double, 3, 6>;  // rows: two pixels, inverse depth; columns: turn, shift

struct Row {
  int view = 0;
  Jacobian by_pose = Jacobian::Zero();
  Eigen::Matrix3d by_point = Eigen::Matrix3d::Zero();
};

class Normal {
 public:
  explicit Normal(const Bundle& b) : b_(b), H_(Eigen::MatrixXd::Zero(size(), size())) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(6 * b_.placed.size()); }

  // The rows of an observation in standard deviations; nothing where it is behind the camera.
  std::optional<Row> row(int view, const Eigen::Vector3d& point, const Eigen::Vector2d& pixel, double sigma_px,
                         double inverse_depth) const {
    const Pose& T = b_.T_world_camera[static_cast<std::size_t>(view)];
    const Eigen::Vector3d p = T.inverse() * point;
    Eigen::Matrix<double, 2, 3> by_point;
    const auto seen = b_.cameras[static_cast<std::size_t>(view)]->project(p, by_point);
    if (!seen) return std::nullopt;
    const double off = (*seen - pixel).norm() / sigma_px;
    const double weight = std::sqrt(std::min(1.0, kernel_sigmas / std::max(off, 1e-12))) / sigma_px;
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    J.topRows<2>() = weight * by_point;
    if (inverse_depth > 0) J(2, 2) = 1 / (p.z() * p.z()) / b_.inverse_depth_sigma;
    Row out;
    out.view = view;
    out.by_pose << J * skew(p), -J * T.linear().transpose();
    out.by_point = J * T.linear().transpose();
    return out;
  }

  void add_pose(const Row& r) { H_.block<6, 6>(6 * r.view, 6 * r.view) += r.by_pose.transpose() * r.by_pose; }

  // All observations of one point, the point eliminated.
  void add_point(const std::vector<Row>& rows) {
    Eigen::Matrix3d V = Eigen::Matrix3d::Zero();
    for (const auto& r : rows) V += r.by_point.transpose() * r.by_point;
    V += point_damping * V.trace() * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d inverse = V.inverse();
    if (!inverse.allFinite()) return;
    for (const auto& r : rows) add_pose(r);
    for (const auto& a : rows) {
      const Eigen::Matrix<double, 6, 3> left = a.by_pose.transpose() * a.by_point * inverse;
      for (const auto& c : rows) H_.block<6, 6>(6 * a.view, 6 * c.view) -= left * (c.by_point.transpose() * c.by_pose);
    }
  }

  std::vector<PoseSigma> solve(int fixed_view) {
    for (std::size_t v = 0; v < b_.placed.size(); ++v)
      if (!b_.placed[v] || static_cast<int>(v) == fixed_view)
        H_.diagonal().segment<6>(static_cast<Eigen::Index>(6 * v)).array() += fixed_weight;
    std::vector<PoseSigma> out(b_.placed.size());
    const Eigen::LDLT<Eigen::MatrixXd> factor(H_);
    if (factor.info() != Eigen::Success || !factor.isPositive()) return out;
    const Eigen::MatrixXd covariance = factor.solve(Eigen::MatrixXd::Identity(size(), size()));
    const auto worst = [&](Eigen::Index first) {
      const Eigen::Matrix3d C = covariance.block<3, 3>(first, first);
      return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).eigenvalues()[2]));
    };
    for (std::size_t v = 0; v < out.size(); ++v) {
      if (!b_.placed[v]) continue;
      const auto first = static_cast<Eigen::Index>(6 * v);
      out[v] = {worst(first + 3), worst(first)};
    }
    return out;
  }

 private:
  const Bundle& b_;
  Eigen::MatrixXd H_;
};

}  // namespace

std::vector<PoseSigma> pose_sigmas(const Bundle& b, int fixed_view) {
  if (b.placed.size() > max_matrix_views || b.placed.empty()) return std::vector<PoseSigma>(b.placed.size());
  Normal normal(b);
  std::vector<std::vector<Row>> of_point(b.points.size());
  for (const auto& o : b.observations) {
    const auto& point = b.points[static_cast<std::size_t>(o.point)];
    if (auto r = normal.row(o.view, point, o.pixel, b.pixel_sigma * o.size, o.inverse_depth))
      of_point[static_cast<std::size_t>(o.point)].push_back(*r);
  }
  for (const auto& rows : of_point)
    if (rows.size() >= 2) normal.add_point(rows);
  for (const auto& k : b.known)
    if (const auto r = normal.row(k.view, k.point, k.pixel, b.known_sigma, 0)) normal.add_pose(*r);
  return normal.solve(fixed_view);
}

}  // namespace bole::rgbd
