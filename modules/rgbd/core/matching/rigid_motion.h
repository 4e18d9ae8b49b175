// The rigid motion between two views by matches with depth.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/transform.h"

namespace bole::rgbd {

// A match as both cameras see it: directions (x / z, y / z, 1) and inverse depths (1 / m; 0: not measured).
struct RayMatch {
  Eigen::Vector3d ray_a, ray_b;
  double inverse_depth_a = 0, inverse_depth_b = 0;
};

struct MotionOptions {
  double max_error = 0.004;           // of the image on the plane z = 1 (pixels / focal length)
  double sigma = 0.0008;              // the same, standard deviation of a good match
  double inverse_depth_sigma = 0.01;  // 1 / m
  int min_inliers = 15;
  std::uint64_t seed = 0;  // same seed, same motion
};

struct Motion {
  Pose T_b_a = Pose::Identity();
  std::vector<char> inlier;  // for each match
  int inliers = 0;
};

// Three matches with depth on both sides (or, with depth on one side only, the three-point pose problem) propose a
// motion; the one that most matches agree with, in both images and in depth, is refined over them. Nothing where fewer
// than min_inliers agree, or where these are so close together that they leave the turn open.
std::optional<Motion> find_motion(const std::vector<RayMatch>& matches, const MotionOptions& options);

// Whether each match agrees with a motion. Matches without any depth do not.
std::vector<char> agreeing(const std::vector<RayMatch>& matches, const Pose& T_b_a, const MotionOptions& options);

// The motion that fits the matches marked in `inlier` best, from a first guess (Gauss-Newton with Cauchy weights).
Pose refine_motion(const std::vector<RayMatch>& matches, const std::vector<char>& inlier, const Pose& T_b_a,
                   const MotionOptions& options);

}  // namespace bole::rgbd
