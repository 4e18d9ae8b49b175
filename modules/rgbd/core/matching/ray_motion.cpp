#include "rgbd/core/matching/ray_motion.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>

namespace bole::rgbd {
namespace {

constexpr double confidence = 0.999;
constexpr int max_trials = 2000, max_ray_trials = 300;
constexpr double max_distance = 1e4;  // of a point, in shifts: neighbouring views are close together

cv::Mat identity() { return cv::Mat::eye(3, 3, CV_64F); }

Pose pose_of(const cv::Mat& R, const cv::Mat& t) {
  Pose T = Pose::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) T.linear()(r, c) = R.at<double>(r, c);
    T.translation()(r) = t.at<double>(r);
  }
  return T;
}

}  // namespace

std::optional<Motion> find_motion_of_rays(const std::vector<RayMatch>& matches, const MotionOptions& options) {
  if (static_cast<int>(matches.size()) < std::max(8, options.min_inliers)) return std::nullopt;
  std::vector<cv::Point2d> a, b;
  for (const auto& m : matches) {
    a.emplace_back(m.ray_a.x(), m.ray_a.y());
    b.emplace_back(m.ray_b.x(), m.ray_b.y());
  }
  // Distance to one line in the image, not to a point: half of the tolerance lets pass as many wrong matches.
  cv::Mat mask;
  const cv::Mat E =
      cv::findEssentialMat(a, b, identity(), cv::RANSAC, confidence, options.max_error / 2, max_ray_trials, mask);
  if (E.rows != 3 || E.cols != 3) return std::nullopt;
  cv::Mat R, t;
  const int good = cv::recoverPose(E, a, b, identity(), R, t, max_distance, mask);
  if (good < options.min_inliers) return std::nullopt;
  Motion out;
  out.T_b_a = pose_of(R, t);
  out.inliers = good;
  for (int i = 0; i < static_cast<int>(matches.size()); ++i)
    out.inlier.push_back(mask.at<std::uint8_t>(i) != 0 ? 1 : 0);
  return out;
}

std::optional<FoundView> find_view(const std::vector<PointRay>& sights, const MotionOptions& options) {
  if (static_cast<int>(sights.size()) < std::max(6, options.min_inliers)) return std::nullopt;
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> image;
  for (const auto& s : sights) {
    points.emplace_back(s.point.x(), s.point.y(), s.point.z());
    image.emplace_back(s.ray.x(), s.ray.y());
  }
  cv::Mat rotation, translation;
  std::vector<int> inliers;
  const bool found =
      cv::solvePnPRansac(points, image, identity(), cv::noArray(), rotation, translation, false, max_trials,
                         static_cast<float>(options.max_error), confidence, inliers, cv::SOLVEPNP_EPNP);
  if (!found || static_cast<int>(inliers.size()) < options.min_inliers) return std::nullopt;
  std::vector<cv::Point3d> good_points;
  std::vector<cv::Point2d> good_image;
  for (const int i : inliers) {
    good_points.push_back(points[static_cast<std::size_t>(i)]);
    good_image.push_back(image[static_cast<std::size_t>(i)]);
  }
  cv::solvePnPRefineLM(good_points, good_image, identity(), cv::noArray(), rotation, translation);
  cv::Mat R;
  cv::Rodrigues(rotation, R);
  const Pose T_camera_world = pose_of(R, translation);
  if (!T_camera_world.matrix().allFinite()) return std::nullopt;
  return FoundView{T_camera_world.inverse(), static_cast<int>(inliers.size())};
}

}  // namespace bole::rgbd
