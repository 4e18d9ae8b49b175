// The parts of the odometry that an inertial unit takes part in.
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "slam/core/odometry/odometry.h"
#include "slam/core/odometry/unit_alone.h"

namespace bole::slam {
namespace {

// Where the unit alone is surer than this, a frame is looked for where it says, even after a gap.
constexpr double max_follow_sigma = 0.5;
// Where points and unit contradict each other, motions count as open that are observed up to this much better.
constexpr double max_tension = 4, doubted_share = 8;

// Standard deviation of a place to which the unit alone carries.
double carried_sigma(const InertialState& state, const std::vector<TrackedFrame>& frames, double until_s) {
  return std::hypot(InertialFilter::shift_sigma(state), astray_m(seconds_alone(frames, frames.size(), until_s)));
}

}  // namespace

// Levels the map by gravity and de-skews the first frame. Its velocity is not known yet.
void Odometry::start_inertial(TrackedFrame& frame) {
  auto start = filter_->look(frame.begin_s);
  if (!start) return;
  if (start->at_rest) rest_from_s_ = frame.begin_s;
  start->at_rest = false;
  Pose level = Pose::Identity();
  level.linear() = rotation_between(-start->gravity_in_sensor, Eigen::Vector3d::UnitZ());
  filter_->start(frame.begin_s, level, *start);
  frame.motion = {level, level};
  if (const auto expected = filter_->predict(frame.begin_s, frame.end_s)) {
    frame.motion = expected->motion;
    filter_->set(expected->state);
    filter_->anchor();
  }
}

// Steady motion looks like rest to the unit. It is at rest where the scanner has not moved either.
void Odometry::confirm_rest(const TrackedFrame& frame) {
  constexpr double rest_s = 0.5, max_shift = 0.02, max_turn_rad = radians(0.1);
  if (!rest_from_s_ || frame.end_s - *rest_from_s_ < rest_s - 1e-3) return;
  const Pose moved = frames_.front().motion.T_map_end.inverse() * frame.motion.T_map_end;
  if (moved.translation().norm() < max_shift && Eigen::AngleAxisd(moved.linear()).angle() < max_turn_rad)
    filter_->hold_still(*rest_from_s_);
  rest_from_s_.reset();
}

bool Odometry::can_be_followed(double begin_s) const {
  return expected_ && begin_s >= last_good().end_s && elastic() &&
         InertialFilter::shift_sigma(expected_->state) < max_follow_sigma;
}

// The points of a frame share errors, so that fewer count against the unit: the same as a prior that is surer.
void Odometry::join_inertial(RegistrationSettings& settings) const {
  const Matrix12d inverse = expected_->covariance.ldlt().solve(Matrix12d::Identity());
  settings.joint_information = 0.5 / settings_.inertial_trust * (inverse + inverse.transpose());
  settings.determined = determined_;
}

InertialState Odometry::found_state(const Registration& r) const {
  return filter_->corrected(*expected_, r.motion, settings_.inertial_trust * r.begin_end_information);
}

// Where a motion is open, the points are kept from moving the frame along it, and the unit does. Returns why the frame
// is to be rejected all the same; empty otherwise.
std::string Odometry::bridged_motion(Registration& r, const std::string& open, const Observability& seen,
                                     const FrameMotion& guess, TrackedFrame& frame, const Features& features,
                                     const Run& run) {
  frame.tension = InertialFilter::tension(*expected_, r.motion);
  // A sensor of few lines sees walls as a pattern that moves with it. The unit notices.
  const double least = settings_.min_observability * (frame.tension > max_tension ? doubted_share : 1);
  const bool weak = left_start_ > 0 && seen.weakest < least;
  if (open.empty() && !weak) {
    found_state_ = found_state(r);
    return {};
  }
  determined_ = seen.determined(least);
  r = followed(frame.motion, guess, frame.begin_s, frame.end_s, features, run);
  determined_.reset();
  found_state_ = found_state(r);
  frame.bridged = true;
  const double sigma = carried_sigma(*found_state_, frames_, frame.end_s);
  if (sigma <= settings_.inertial_bridge) {
    held_ = true;
    return {};
  }
  const std::string text =
      open.empty() ? "the surroundings leave a direction of motion open: " + seen.motion_text() : open;
  return text + ", and the inertial unit alone knows the place only to " + number_text(std::round(100 * sigma) / 100) +
         " m (inertial_bridge)";
}

// The state goes on from what registration found, or from what the unit says alone.
void Odometry::settle_inertial(TrackedFrame& frame) {
  frame.joined = frame.ok && joined_ && found_state_;
  if (frame.joined) {
    filter_->set(*found_state_);
    return confirm_rest(frame);
  }
  rest_from_s_.reset();
  if (frame.ok) {
    frame.bridged = false;
    if (filter_->started()) return filter_->restart(frame.end_s, frame.motion.T_map_end);
    if (auto start = filter_->look(frame.end_s)) {
      start->at_rest = false;
      filter_->start(frame.end_s, frame.motion.T_map_end, *start);
      filter_->restart(frame.end_s, frame.motion.T_map_end);
    }
    return;
  }
  frame.bridged = false;
  if (!expected_) return;
  frame.motion = expected_->motion;
  filter_->set(expected_->state);
  frame.bridged = carried_sigma(expected_->state, frames_, frame.end_s) <= settings_.inertial_bridge;
}

}  // namespace bole::slam
