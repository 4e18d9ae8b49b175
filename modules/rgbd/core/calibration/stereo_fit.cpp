#include "rgbd/core/calibration/stereo_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>

#include "base/error.h"
#include "base/statistics.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t min_pairs = 4;
constexpr std::size_t min_common = 8;
constexpr double same_time_s = 0.01;

cv::Mat matrix_of(const CameraModel& camera) {
  return (cv::Mat_<double>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
}

cv::Mat distortion_of(const CameraModel& camera) {
  cv::Mat out(1, 5, CV_64F);
  for (int i = 0; i < 5; ++i) out.at<double>(i) = camera.distortion[static_cast<std::size_t>(i)];
  return out;
}

struct Pairs {
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> color, other;
  std::vector<Pose> T_color_other;  // of each view alone
};

void add_pair(const BoardShot& a, const ShotFit& fit_a, const BoardShot& b, const ShotFit& fit_b, Pairs& pairs) {
  const auto key = [](const Eigen::Vector3d& p) {
    return std::pair(std::lround(1e4 * p.x()), std::lround(1e4 * p.y()));
  };
  std::map<std::pair<long, long>, Eigen::Vector2d> of_b;
  for (const auto& c : b.corners) of_b.emplace(key(c.point), c.pixel);
  std::vector<cv::Point3f> object;
  std::vector<cv::Point2f> color, other;
  for (const auto& c : a.corners)
    if (const auto it = of_b.find(key(c.point)); it != of_b.end()) {
      object.emplace_back(static_cast<float>(c.point.x()), static_cast<float>(c.point.y()), 0.0F);
      color.emplace_back(static_cast<float>(c.pixel.x()), static_cast<float>(c.pixel.y()));
      other.emplace_back(static_cast<float>(it->second.x()), static_cast<float>(it->second.y()));
    }
  if (object.size() < min_common) return;
  pairs.object.push_back(std::move(object));
  pairs.color.push_back(std::move(color));
  pairs.other.push_back(std::move(other));
  pairs.T_color_other.push_back(fit_a.T_camera_board * fit_b.T_camera_board.inverse());
}

// Leaves out views whose own pose is far from the others': a board that one camera took for shifted by a square fits
// that camera, and not the pair.
void drop_strangers(Pairs& pairs) {
  constexpr double min_apart = 0.01;  // metres
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const auto& T : pairs.T_color_other) values.push_back(T.translation()[k]);
    middle[k] = upper_median(std::move(values));
  }
  std::vector<double> apart;
  for (const auto& T : pairs.T_color_other) apart.push_back((T.translation() - middle).norm());
  const double limit = std::max(min_apart, 5 * upper_median(std::vector<double>(apart)));
  Pairs kept;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (apart[i] > limit) continue;
    kept.object.push_back(pairs.object[i]);
    kept.color.push_back(pairs.color[i]);
    kept.other.push_back(pairs.other[i]);
    kept.T_color_other.push_back(pairs.T_color_other[i]);
  }
  pairs = std::move(kept);
}

// Standard error of the mean of the views' own poses about the common one.
Vector6d scatter_of(const Pairs& pairs, const Pose& T_color_other) {
  Vector6d sum = Vector6d::Zero();
  for (const auto& T : pairs.T_color_other) {
    Vector6d difference;
    difference << so3_log(Eigen::Quaterniond(T.linear() * T_color_other.linear().transpose())),
        T.translation() - T_color_other.translation();
    sum += difference.cwiseAbs2();
  }
  const double n = static_cast<double>(pairs.T_color_other.size());
  return (sum / (n * (n - 1))).cwiseSqrt();
}

}  // namespace

StereoFit fit_stereo(const ViewSource& color_views, const std::vector<BoardShot>& color_shots, const CameraFit& color,
                     const ViewSource& other_views, const std::vector<BoardShot>& other_shots, const CameraFit& other) {
  Pairs pairs;
  for (std::size_t a = 0; a < color_shots.size(); ++a)
    for (std::size_t b = 0; b < other_shots.size(); ++b) {
      const bool both = color_shots[a].left_out.empty() && other_shots[b].left_out.empty();
      const double apart_s = color_views.time_s(color_shots[a].view) - other_views.time_s(other_shots[b].view);
      // Counted otherwise, the board is shifted by a square.
      const bool same = color_shots[a].layout == other_shots[b].layout;
      if (both && same && std::abs(apart_s) <= same_time_s)
        add_pair(color_shots[a], color.shots[a], other_shots[b], other.shots[b], pairs);
    }
  const auto common = pairs.object.size();
  if (common > 0) drop_strangers(pairs);
  if (pairs.object.size() < min_pairs)
    throw bad_input(std::to_string(pairs.object.size()) + " views of the board were taken by both cameras",
                    std::to_string(min_pairs) + " at least, at the same times");
  cv::Mat rotation, shift, essential, fundamental;
  const cv::TermCriteria enough(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-12);
  StereoFit fit;
  cv::Mat matrix_color = matrix_of(color.camera), distortion_color = distortion_of(color.camera);
  cv::Mat matrix_other = matrix_of(other.camera), distortion_other = distortion_of(other.camera);
  // x_color = R x_other + t: the first camera of OpenCV is the other one.
  fit.rms_px = cv::stereoCalibrate(pairs.object, pairs.other, pairs.color, matrix_other, distortion_other, matrix_color,
                                   distortion_color, {color.camera.width, color.camera.height}, rotation, shift,
                                   essential, fundamental, cv::CALIB_FIX_INTRINSIC, enough);
  Eigen::Matrix3d turn;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) turn(row, column) = rotation.at<double>(row, column);
    fit.T_color_other.translation()[row] = shift.at<double>(row);
  }
  fit.T_color_other.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  fit.views = pairs.object.size();
  fit.left_out = common - fit.views;
  fit.sd = scatter_of(pairs, fit.T_color_other);
  return fit;
}

}  // namespace bole::rgbd
