#include "slam/core/odometry/unbend.h"

#include "base/angles.h"

namespace bole::slam {
namespace {

// Begin and end converge slowly from a prediction that is wrong by degrees: 30 iterations are too few.
constexpr int iterations = 60;
// The begin of a rigid frame is its middle minus half the assumed motion, so it is known no better than that.
constexpr double begin_sigma = 0.05, begin_sigma_rad = radians(2);
constexpr double motion_sigma = 0.04, motion_sigma_rad = radians(2);

}  // namespace

double bend_rad(const FrameMotion& assumed, const FrameMotion& found) {
  return Eigen::AngleAxisd(assumed.delta().linear().transpose() * found.delta().linear()).angle();
}

Registration register_bent(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& assumed,
                           RegistrationSettings settings, const Run& run) {
  settings.model = MotionModel::elastic;
  settings.priors.reset();    // they assume that the motion is known
  settings.two_step = false;  // too few points per unknown
  settings.iterations = iterations;
  settings.begin_sigma = begin_sigma;
  settings.begin_sigma_rad = begin_sigma_rad;
  settings.motion_sigma = motion_sigma;
  settings.motion_sigma_rad = motion_sigma_rad;
  return register_frame(features, maps, assumed, settings, run);
}

}  // namespace bole::slam
