#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "rgbd/core/board/charuco_board.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t min_corners = 6;
constexpr double min_width_share = 0.05;    // of the corners' extent: narrower is a line
constexpr double ambiguous_ratio = 1.5;     // of the residuals of the two poses
constexpr double ambiguous_floor_px = 0.5;  // below, both fit

bool in_one_line(const std::vector<BoardCorner>& corners) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& c : corners) mean += c.point.head<2>() / static_cast<double>(corners.size());
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  for (const auto& c : corners) S += (c.point.head<2>() - mean) * (c.point.head<2>() - mean).transpose();
  const double half = S.trace() / 2, root = std::sqrt(std::max(0.0, half * half - S.determinant()));
  return half - root < min_width_share * min_width_share * (half + root);
}

Pose pose_of(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  cv::Mat R;
  cv::Rodrigues(rotation_vector, R);
  Pose T_camera_board = Pose::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) T_camera_board.linear()(r, c) = R.at<double>(r, c);
    T_camera_board.translation()(r) = translation.at<double>(r);
  }
  return T_camera_board.inverse();
}

double residual_of(const Pose& T_board_camera, const std::vector<BoardCorner>& corners, const CameraModel& camera) {
  const Pose T_camera_board = T_board_camera.inverse();
  double sum = 0;
  for (const auto& c : corners) {
    const auto pixel = camera.project(T_camera_board * c.point);
    if (!pixel) return std::numeric_limits<double>::infinity();
    sum += (*pixel - c.pixel).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(corners.size()));
}

}  // namespace

std::optional<BoardPose> board_pose(const std::vector<BoardCorner>& corners, const CameraModel& camera) {
  if (corners.size() < min_corners || in_one_line(corners)) return std::nullopt;
  std::vector<cv::Point3d> board;
  std::vector<cv::Point2d> plane;
  for (const auto& c : corners) {
    const Eigen::Vector3d d = camera.direction(c.pixel);
    board.emplace_back(c.point.x(), c.point.y(), 0);
    plane.emplace_back(d.x(), d.y());
  }
  const cv::Mat identity = cv::Mat::eye(3, 3, CV_64F);
  std::vector<cv::Mat> rotations, translations;
  cv::solvePnPGeneric(board, plane, identity, cv::noArray(), rotations, translations, false, cv::SOLVEPNP_IPPE);
  std::vector<std::pair<double, Pose>> fits;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    cv::solvePnPRefineLM(board, plane, identity, cv::noArray(), rotations[i], translations[i]);
    const Pose T = pose_of(rotations[i], translations[i]);
    if (T.matrix().allFinite()) fits.emplace_back(residual_of(T, corners, camera), T);
  }
  std::erase_if(fits, [](const auto& f) { return !std::isfinite(f.first); });
  if (fits.empty()) return std::nullopt;
  std::ranges::sort(fits, {}, [](const auto& f) { return f.first; });
  BoardPose out;
  out.T_board_camera = fits[0].second;
  out.residual_px = fits[0].first;
  // Two starts that end in one pose are no ambiguity.
  constexpr double same_rad = 0.02;
  out.ambiguous =
      fits.size() > 1 && fits[1].first < ambiguous_ratio * std::max(fits[0].first, ambiguous_floor_px) &&
      so3_log(Eigen::Quaterniond(fits[0].second.linear().transpose() * fits[1].second.linear())).norm() > same_rad;
  return out;
}

}  // namespace bole::rgbd
