#include "slam/core/odometry/unbend.h"

#include <numbers>

namespace bole::slam {
namespace {

constexpr double rad(double deg) { return deg * std::numbers::pi / 180; }

// Begin and end converge slowly from a prediction that is off by degrees: 30 rounds do not do.
constexpr int rounds = 60;
// The begin of a rigid frame is its middle less half the motion that was assumed, so it is known no better than that.
constexpr double begin_sigma_m = 0.05, begin_sigma_rad = rad(2);
constexpr double motion_sigma_m = 0.04, motion_sigma_rad = rad(2);

}  // namespace

double bend_rad(const FrameMotion& assumed, const FrameMotion& found) {
  return Eigen::AngleAxisd(assumed.delta().linear().transpose() * found.delta().linear()).angle();
}

Registration register_bent(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& assumed,
                           RegistrationSettings settings, const Run& run) {
  settings.model = MotionModel::elastic;
  settings.priors.reset();    // they tell how well the motion is known that is in doubt here
  settings.two_step = false;  // which leaves unknowns of begin and end to too few points
  settings.rounds = rounds;
  settings.begin_sigma_m = begin_sigma_m, settings.begin_sigma_rad = begin_sigma_rad;
  settings.motion_sigma_m = motion_sigma_m, settings.motion_sigma_rad = motion_sigma_rad;
  return register_frame(features, maps, assumed, settings, run);
}

}  // namespace bole::slam
