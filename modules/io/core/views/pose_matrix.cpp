#include "io/core/views/pose_matrix.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace bole::io {

Pose pose_from_matrix(const std::vector<double>& rows, const std::string& place) {
  constexpr double max_error = 2e-3;  // datasets round their matrices
  constexpr const char* needed = "4 x 4 numbers, rows first: a rotation and a translation";
  if (rows.size() != 16 && rows.size() != 12)
    throw bad_input(place + " has " + std::to_string(rows.size()) + " numbers", needed);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(rows.data());
  const bool numbers = std::ranges::all_of(rows, [](double v) { return std::isfinite(v); });
  const bool last_row = rows.size() == 12 || (std::abs(rows[12]) < 1e-9 && std::abs(rows[13]) < 1e-9 &&
                                              std::abs(rows[14]) < 1e-9 && std::abs(rows[15] - 1) < 1e-6);
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  if (!numbers || !last_row ||
      !((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < max_error) ||
      rotation.determinant() < 0)
    throw bad_input(place + " is no rotation and translation", needed);
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  pose.translation() = matrix.col(3);
  return pose;
}

Pose from_opengl(const Pose& T_world_opengl) {
  Pose pose = T_world_opengl;
  pose.linear().col(1) *= -1;
  pose.linear().col(2) *= -1;
  return pose;
}

}  // namespace bole::io
