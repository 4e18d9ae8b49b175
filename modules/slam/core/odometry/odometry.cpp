#include "slam/core/odometry/odometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"
#include "base/statistics.h"
#include "slam/core/odometry/observability.h"
#include "slam/core/odometry/point_matches.h"
#include "slam/core/odometry/relocalise.h"
#include "slam/core/odometry/unbend.h"
#include "slam/core/stopwatch.h"

namespace bole::slam {
namespace {

constexpr std::size_t min_features = 100;
constexpr double start_keyframes =
    3;  // the place of the start reaches as far as this many keyframe distances, see open_motion()
constexpr double min_share_at_start = 0.5;  // of min_observability; plots have 0.7 of it and more, fields 0.2
constexpr std::size_t first_keyframes = 6;  // made from every frame at the start with features `ground`
constexpr double min_conditioning = 2e-4;   // forest plots have 0.05 to 0.5, vine rows over bare ground 0.001
constexpr std::size_t usual_frames = 20;
constexpr double min_share_of_usual = 0.5;  // of the overlap of the frames before
// See Relocalisation. After two places were similar, the next frames must be clearer, because chance has several tries.
constexpr double max_doubt = 0.5, max_doubt_again = 0.25;
// See is_suspect() and unbent(). In walking, the motion that de-skews a frame is wrong by up to 2 deg.
constexpr double max_bend_rad = radians(3), max_apart = 0.2;
constexpr double sure_share = 0.9, settled_share = 0.85;  // of the usual overlap
constexpr double sure_overlap = 0.6;                      // below it a rigid frame is also searched for farther away

// A walking person changes speed by up to about 0.4 m/s and turn rate by about 0.2 rad/s within a tenth of a second.
constexpr double stride_s = 1.05;    // two steps
constexpr double max_join_s = 0.15;  // frames farther apart than this have a gap between them
constexpr double gait_acceleration = 4, gait_angular_acceleration = 2;
constexpr double bound_sigmas = 2;  // in a longer frame, whose ends are vague, these bounds count as two deviations

// See Odometry::matched_motion() and motion_found().
constexpr double matched_share = 0.5, max_gait_changes = 2;

// Without a robust kernel (SPEC A) walls grow to several centimetres, and thick walls witness little: 2.1 and more on
// plots that were mapped to a few centimetres. Such frames are reported instead, see report_weak_frames(). Corridors
// and fields have at most 1.9.
double needed_observability(const SlamSettings& settings) {
  return (is_plain(settings.weights) ? 0.85 : 1.0) * settings.min_observability;
}

// Whether the motion over a frame can differ by `change` from the one before, or from another estimate of it.
bool can_be_walked(const Vector6d& change, double span_s) {
  const double limit = max_gait_changes * span_s * span_s;
  return change.head<3>().norm() < limit * gait_angular_acceleration &&
         change.tail<3>().norm() < limit * gait_acceleration;
}

// Each pose is made from the last one. Without this, rotations are no longer orthonormal after about a hundred frames.
Pose orthonormal(Pose T) {
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

std::string percent(double share) { return number_text(std::round(share * 100)) + " %"; }

}  // namespace

Odometry::Odometry(const SlamSettings& settings, const InertialUnit* unit)
    : settings_(settings),
      local_map_(settings.cell_size, static_cast<std::size_t>(settings.neighbour_keyframes), settings.local_map),
      last_frame_map_(2 * settings.cell_size) {
  if (unit) filter_.emplace(*unit);
}

Odometry::~Odometry() = default;

// Constant velocity from the last good frame. Over a gap, the mean motion of the last stride predicts better than one
// moment of the gait.
FrameMotion Odometry::predicted(double begin_s, double end_s) const {
  if (frames_.empty()) return {};
  const auto& last = last_good();
  const double last_span_s = last.end_s - last.begin_s, gap_s = std::max(0.0, begin_s - last.end_s);
  if (last_good_ == 0 || last_span_s <= 0) return {last.motion.T_map_end, last.motion.T_map_end};
  Vector6d velocity = known_by_its_middle(last) ? mean_velocity(0.5 * last_span_s)
                                                : Vector6d(se3_log(last.motion.delta()) / last_span_s);
  if (gap_s > max_join_s) velocity = mean_velocity(stride_s);
  if (!elastic()) {
    const double ahead_s = std::min(0.5 * (begin_s + end_s) - last.mid_s(), 1.5);
    return motion_about(last.motion.at(0.5) * se3_exp(velocity * ahead_s), velocity, end_s - begin_s);
  }
  FrameMotion out;
  out.T_map_begin = last.motion.T_map_end * se3_exp(velocity * std::min(gap_s, 1.5));
  out.T_map_end = out.T_map_begin * se3_exp(velocity * (end_s - begin_s));
  return out;
}

bool Odometry::known_by_its_middle(const TrackedFrame& frame) const {
  return !elastic() || frame.end_s - frame.begin_s > longest_straight_frame_s;
}

// From the good frame at least `over_s` before the last good one. The registration of a rigid frame determines the pose
// of its middle. Begin and end depend on the motion assumed within the frame, and a velocity taken from them feeds its
// own error back with the opposite sign: it oscillates. So rigid frames are compared by their middles, and so are long
// elastic ones, whose ends are vague.
Vector6d Odometry::mean_velocity(double over_s) const {
  if (last_good_ == 0) return Vector6d::Zero();
  const auto& last = last_good();
  std::size_t k = last_good_ - 1;
  while (k > 0 && (!frames_[k].ok || last.end_s - frames_[k].end_s < over_s)) --k;
  const auto& first = frames_[k];
  if (!known_by_its_middle(last))
    return se3_log(first.motion.T_map_end.inverse() * last.motion.T_map_end) / (last.end_s - first.end_s);
  return se3_log(first.motion.at(0.5).inverse() * last.motion.at(0.5)) / (last.mid_s() - first.mid_s());
}

// The motion over a frame whose middle was found by registration, at the speed since the middle of the last frame.
FrameMotion Odometry::with_speed_found(const FrameMotion& found, double begin_s, double end_s) const {
  const auto& last = last_good();
  const double since_s = 0.5 * (begin_s + end_s) - last.mid_s();
  if (since_s <= 0 || begin_s - last.end_s > max_join_s) return found;
  const Pose T_map_mid = found.at(0.5);
  return motion_about(T_map_mid, se3_log(last.motion.at(0.5).inverse() * T_map_mid) / since_s, end_s - begin_s);
}

// The two steps of LOAM: the frame is matched against the last one for the motion, and in registered() against the map
// for the pose.
FrameMotion Odometry::guessed(const FrameMotion& prediction, double begin_s, double end_s, const Features& features,
                              const Run& run) {
  if (settings_.deskew == Deskew::none) return {prediction.at(0.5), prediction.at(0.5)};
  if (settings_.first_guess == FirstGuess::matched_motion) return matched_motion(prediction, begin_s, features, run);
  if (settings_.first_guess != FirstGuess::last_frame) return prediction;
  auto settings = base_settings();
  const auto& last = last_good();
  if (settings.priors) {
    // De-skewing uses the priors of all points; those of the first frame have an exact pose.
    settings.priors->reference_points = true;
    settings.priors->reference_covariance = last.covariance;
    settings.priors->reference_position = last.motion.T_map_end.translation();
  }
  const auto r = register_frame(features.query, last_frame_map_, prediction, settings, run);
  if (r.overlap < settings_.lost_overlap || r.conditioning < min_conditioning) return prediction;
  motion_covariance_ = r.covariance;
  return with_speed_found(r.motion, begin_s, end_s);
}

// SPEC A3: the motion within the frame, constant in velocity, is what is estimated. The frame begins where the last one
// ended, and its points are matched against single points of that one.
//
// The last frame was de-skewed with its own motion. Where that was wrong by e, its points at time s (0 to 1) are wrong
// by e (s - 1), seen from its end, and the motion that fits them now is wrong by -e sum s (1 - s) / sum s^2. That is
// half of e with the opposite sign where features are all around. Where most are seen early in a frame it is more than
// e, and the motion swings up until the frames are bent and the track is lost. So the motion goes only a part of the
// way from constant velocity, as in LOAM's program, which takes 25 steps of a twentieth. The papers do not say how they
// damp it.
FrameMotion Odometry::matched_motion(const FrameMotion& prediction, double begin_s, const Features& features,
                                     const Run& run) {
  const auto& last = last_good();
  if (!last_frame_points_ || begin_s - last.end_s > max_join_s) return prediction;
  auto settings = base_settings();
  settings.model = MotionModel::end;
  settings.points = last_frame_points_.get();
  settings.coarse_iterations = 4;  // a wide gate comes first
  settings.two_step = settings_.solve != Solve::joint;
  const auto r =
      register_frame(features.query, last_frame_map_, {last.motion.T_map_end, prediction.T_map_end}, settings, run);
  if (r.overlap < settings_.lost_overlap || r.conditioning < min_conditioning) return prediction;
  motion_covariance_ = r.covariance;
  const Vector6d change = se3_log(prediction.delta().inverse() * r.motion.delta());
  return {r.motion.T_map_begin, r.motion.T_map_begin * prediction.delta() * se3_exp(matched_share * change)};
}

// Keeps what the next frame is matched against.
void Odometry::remember_frame(const TrackedFrame& frame, const Features& features) {
  if (settings_.first_guess == FirstGuess::last_frame) {
    last_frame_map_.clear();
    insert_keyframe(make_keyframe(frame.index, frame.end_s, features.map, frame.motion), last_frame_map_);
  } else if (settings_.first_guess == FirstGuess::matched_motion) {
    last_frame_points_ = std::make_unique<PointMatches>(
        features.map, frame.motion, SensorPrior{settings_.range_sigma, radians(settings_.angle_sigma_deg)},
        frame.covariance);
  }
}

// The motion over a frame that was registered, for de-skewing it. SPEC A5 takes it from the end of the last frame to
// the end of this one.
FrameMotion Odometry::motion_found(const FrameMotion& found, double begin_s, double end_s) const {
  if (settings_.first_guess != FirstGuess::matched_motion) return with_speed_found(found, begin_s, end_s);
  const auto& last = last_good();
  if (settings_.deskew != Deskew::twice || begin_s - last.end_s > max_join_s) return found;
  // The errors of both ends add up in this motion. Where no walker can have made the difference, the first one stays.
  const FrameMotion replaced{last.motion.T_map_end, found.T_map_end};
  const Vector6d change = se3_log(found.delta().inverse() * replaced.delta());
  return can_be_walked(change, end_s - begin_s) ? replaced : found;
}

// Priors of the motion over a frame that follows the last one after a gap.
void Odometry::hold_to_gait(RegistrationSettings& settings, double gap_s) const {
  const double span_s = std::max(0.02, last_good().end_s - last_good().begin_s), changed_s = std::max(span_s, gap_s);
  settings.begin_sigma = settings_.continuity_sigma + gait_acceleration * gap_s * changed_s;
  settings.begin_sigma_rad = radians(settings_.continuity_sigma_deg) + gait_angular_acceleration * gap_s * changed_s;
  settings.motion_sigma = gait_acceleration * span_s * changed_s;
  settings.motion_sigma_rad = gait_angular_acceleration * span_s * changed_s;
  // Within a tenth of a second a gait bends the motion by 5 mm, which the adjustment of the whole path mends; within a
  // fifth by 2 cm, and the frame no longer fits the map. With a bend the points leave the end of a frame vague. Handed
  // on as if it were certain it would bend the next frame, whose end would be off by as much: at rest the path then
  // wanders by centimetres.
  if (span_s > longest_straight_frame_s) {
    settings.motion_sigma /= bound_sigmas;
    settings.motion_sigma_rad /= bound_sigmas;
    const double bend_per_acceleration = span_s * span_s / 8;
    settings.bend = BendPrior{gait_acceleration / bound_sigmas * bend_per_acceleration,
                              gait_angular_acceleration / bound_sigmas * bend_per_acceleration};
    settings.begin_covariance = last_good().end_covariance;
  }
}

RegistrationSettings Odometry::base_settings() const {
  RegistrationSettings settings;
  settings.iterations = settings_.iterations;
  settings.sigma = settings_.range_sigma;
  settings.kernel_sigmas = settings_.kernel_sigmas;
  settings.two_step = settings_.solve == Solve::two_step;
  settings.plain = is_plain(settings_.weights);
  settings.equal = settings_.weights == Weights::equal;
  if (uses_priors(settings_.weights))
    settings.priors = AdjustmentPriors{.sensor = {settings_.range_sigma, radians(settings_.angle_sigma_deg)},
                                       .motion_covariance = motion_covariance_};
  return settings;
}

// Registers where the sensor is expected. Where that does not fit, or after a gap, searches everywhere the sensor can
// have moved to.
Registration Odometry::registered(const FrameMotion& prediction, const FrameMotion& guess, double begin_s, double end_s,
                                  const Features& features, const Run& run) {
  Registration r;
  if (begin_s - last_good().end_s <= max_join_s || can_be_followed(begin_s)) {
    r = followed(prediction, guess, begin_s, end_s, features, run);
    if (r.overlap >= min_overlap()) return r;
  }
  Registration again = searched(begin_s, end_s, features, run);
  if (again.overlap <= r.overlap) return r;
  joined_ = false;
  found_again_after_s_ = begin_s - last_good().end_s;
  // A frame that did not fit because it is bent, and not because of a gap, is found in wrong places as well.
  unsettled_ = settings_.deskew == Deskew::once && again.overlap < sure_share * usual_overlap();
  return again;
}

Registration Odometry::searched(double begin_s, double end_s, const Features& features, const Run& run) {
  const auto& last = last_good();
  const double gap_s = std::max(0.0, begin_s - last.end_s);
  const LastSeen seen{last.motion.T_map_end, mean_velocity(stride_s), 0.5 * (begin_s + end_s) - last.end_s};
  auto settings = base_settings();
  auto search = relocalise(features.query, local_map_.maps(), seen, end_s - begin_s, settings, run);
  doubt_ = search.doubt;
  if (!elastic()) return search.found;
  settings.model = MotionModel::elastic;
  hold_to_gait(settings, gap_s);
  return register_frame(features.query, local_map_.maps(), search.found.motion, settings, run);
}

Registration Odometry::followed(const FrameMotion& prediction, const FrameMotion& guess, double begin_s, double end_s,
                                const Features& features, const Run& run) {
  RegistrationSettings settings = base_settings();
  if (elastic()) {
    settings.model = MotionModel::elastic;
    joined_ = expected_.has_value();
    if (joined_) {
      join_inertial(settings);
      return register_frame(features.query, local_map_.maps(), expected_->motion, settings, run);
    }
    hold_to_gait(settings, std::max(0.0, begin_s - last_good().end_s));
    return register_frame(features.query, local_map_.maps(), guess, settings, run);
  }
  settings.model = MotionModel::rigid;
  auto r = register_frame(features.query, local_map_.maps(), guess, settings, run);
  if (r.overlap < sure_overlap) {
    // After a sudden turn the prediction is wrong. Search wider, from the prediction and from the last pose.
    settings.coarse_iterations = 8;
    settings.iterations = settings_.iterations + 8;
    const Pose& T_map_last = last_good().motion.T_map_end;
    for (const auto& from : {guess, FrameMotion{T_map_last, T_map_last}}) {
      auto wider = register_frame(features.query, local_map_.maps(), from, settings, run);
      if (wider.overlap > r.overlap) r = std::move(wider);
    }
    settings = base_settings();
  }
  if (settings_.deskew == Deskew::none) return r;
  if (settings_.deskew == Deskew::twice) {
    // SPEC A5: the motion that was found replaces the guess, and the raw frame is registered again.
    settings.coarse_iterations = 0;
    if (settings.priors) settings.priors->motion_covariance = r.covariance + last_good().covariance;
    r = register_frame(features.query, local_map_.maps(), motion_found(r.motion, begin_s, end_s), settings, run);
  }
  // The motion that de-skewed the frame was measured, and stays.
  if (settings_.first_guess == FirstGuess::matched_motion) return r;
  const FrameMotion found = with_speed_found(r.motion, begin_s, end_s);
  // A frame that was de-skewed with a motion that was found hardly differs from it, and may be bent all the same: what
  // tells is that the carrier did not go on as before.
  if (is_suspect(r, prediction, found)) return unbent(r, found, prediction, features, run);
  r.motion = found;
  return r;
}

// `r`, or a registration with begin and end fitted where the frame is bent. Where neither converges, or they converge
// to different places, the pose of the frame is unknown.
Registration Odometry::unbent(Registration r, const FrameMotion& found, const FrameMotion& assumed,
                              const Features& features, const Run& run) {
  const double min_settled = settled_share * usual_overlap();
  auto fitted = register_bent(features.query, local_map_.maps(), assumed, base_settings(), run);
  if (bend_rad(assumed, fitted.motion) > max_bend_rad && fitted.overlap > r.overlap) {
    bent_ = true;
    unsettled_ = !fitted.converged && fitted.overlap < min_settled;
    return fitted;
  }
  const double apart = (fitted.motion.at(0.5).translation() - r.motion.at(0.5).translation()).norm();
  unsettled_ = !r.converged && r.overlap < min_settled && (!fitted.converged || apart > max_apart);
  r.motion = found;
  return r;
}

// The median of the last good frames; 0 where there are too few.
double Odometry::usual_overlap() const {
  std::vector<double> before;
  for (std::size_t k = frames_.size(); before.size() < usual_frames && k-- > 1;)
    if (frames_[k].ok) before.push_back(frames_[k].overlap);
  if (before.size() < 5) return 0;
  return upper_median(std::move(before));
}

// A frame that agrees much less than those before it is in a wrong place, even where a quarter of its points, most of
// them ground, happen to agree.
double Odometry::min_overlap() const { return std::max(settings_.lost_overlap, min_share_of_usual * usual_overlap()); }

// Whether a frame may be bent because it was de-skewed with a wrong motion. The motion that is found does not show it,
// because a bent frame converges near the assumption. The frame hardly converges, or agrees less.
bool Odometry::is_suspect(const Registration& r, const FrameMotion& assumed, const FrameMotion& found) const {
  return !r.converged || r.overlap < sure_share * usual_overlap() || bend_rad(assumed, found) > max_bend_rad;
}

// A single sparse frame may look open by chance, while open surroundings stay open. So the last frames count together
// by their geometric mean. Left out are the first frame, which had no map, empty frames, which were not registered, and
// those at the place of the start (see open_motion()).
double Odometry::recent_observability(double of_this_frame) const {
  constexpr std::size_t max_frames = 4;
  double sum = std::log(std::max(of_this_frame, 1e-6));
  std::size_t n = 1;
  for (std::size_t k = frames_.size(); n < max_frames && k-- > std::max<std::size_t>(1, left_start_);)
    if (frames_[k].iterations > 0) {
      sum += std::log(std::max(frames_[k].observability, 1e-6));
      ++n;
    }
  return std::exp(sum / static_cast<double>(n));
}

// At rest the map is one frame, seen again on the same scan lines. They tell little about a shift across them, even in
// a plot, and so do the first steps. So weakly determined motions are let pass until the sensor has left the place of
// the start. All of that is withdrawn where no frame is well determined by then, as in a corridor, which the sensor may
// leave unnoticed, or where an impossible motion is found.
std::string Odometry::open_motion(const Registration& r, const Observability& seen) {
  std::string text = "the surroundings leave a direction of motion open: " + seen.motion_text();
  if (r.conditioning < min_conditioning) return text;
  const double distance = (r.motion.T_map_end.translation() - keyframes_.front().T_map_keyframe.translation()).norm();
  if (left_start_ == 0 && distance >= start_keyframes * settings_.keyframe_distance) left_start_ = frames_.size();
  const double recent = recent_observability(seen.weakest), needed = needed_observability(settings_);
  if (recent >= needed) {
    held_ |= r.overlap >= min_overlap();
    return {};
  }
  if (left_start_ > 0 || recent < min_share_at_start * needed) return text;
  open_at_start_ = std::move(text);
  return {};
}

void Odometry::withdraw_start() {
  for (std::size_t k = 1; k < frames_.size(); ++k) frames_[k].ok = false;
  last_good_ = 0;
  failed_in_a_row_ = static_cast<int>(frames_.size()) - 1;
}

void Odometry::finish() {
  if (held_ || open_at_start_.empty()) return;
  why_failed_ = open_at_start_;
  withdraw_start();
}

std::string Odometry::objection(const Registration& r, const std::string& open, const FrameMotion& prediction,
                                double begin_s, double end_s) const {
  if (const double needed = min_overlap(); r.overlap < needed)
    return "only " + percent(r.overlap) + " of " + std::to_string(r.tried) + " points agree with the map; " +
           percent(needed) + " are needed";
  if (!r.motion.T_map_end.matrix().allFinite() || !r.motion.T_map_begin.matrix().allFinite())
    return "the solution is not finite";
  const double speed =
      (r.motion.T_map_end.translation() - r.motion.T_map_begin.translation()).norm() / std::max(0.02, end_s - begin_s);
  if (speed > settings_.max_speed) return "the motion would be " + number_text(std::round(speed * 10) / 10) + " m/s";
  if (!open.empty()) return open;
  if (unsettled_)
    return "the registration does not converge: " + percent(r.overlap) + " of its points agree with the map after " +
           std::to_string(r.iterations) + " iterations; " + percent(usual_overlap()) + " did before";
  const double elapsed_s = end_s - last_good().end_s;
  const double leap = (r.motion.T_map_end.translation() - prediction.T_map_end.translation()).norm();
  if (leap > 0.3 + settings_.max_speed * elapsed_s)
    return "the pose would jump by " + number_text(std::round(leap * 100) / 100) + " m";
  return doubt_text();
}

std::string Odometry::doubt_text() const {
  if (found_again_after_s_ <= 0 || doubt_ <= (doubted_ ? max_doubt_again : max_doubt)) return {};
  return "two places fit equally well " + number_text(std::round(found_again_after_s_ * 10) / 10) +
         " s after the last good frame, with odds of " + number_text(std::round(100 * doubt_) / 100) + " to 1";
}

void Odometry::add(std::size_t index, double begin_s, double end_s, const Features& features, const Run& run) {
  TrackedFrame frame;
  frame.index = index;
  frame.begin_s = begin_s;
  frame.end_s = end_s;
  if (frames_.empty()) return add_first(frame, features);

  const bool determined = locate(frame, features, run);
  if (filter_) settle_inertial(frame);
  if (frame.ok)
    failed_in_a_row_ = 0;
  else if (!frame.bridged)
    ++failed_in_a_row_;
  travelled_ += (frame.motion.T_map_end.translation() - frames_.back().motion.T_map_end.translation()).norm();
  frames_.push_back(frame);
  if (frame.ok) last_good_ = frames_.size() - 1;
  if (!determined) withdraw_start();
  doubted_ = !frame.ok && (doubted_ || why_failed_ == doubt_text());
  Stopwatch watch;
  if (frame.ok && keyframe_due(frame)) add_keyframe(features, frames_.back());
  frames_.back().keyframe = keyframes_.size() - 1;
  if (frame.ok) remember_frame(frame, features);
  times_.map_s += watch.lap();
}

void Odometry::add_first(TrackedFrame frame, const Features& features) {
  if (features.query.size() < min_features) return;  // too few to start a map with
  if (filter_) start_inertial(frame);
  frames_.push_back(std::move(frame));
  add_keyframe(features, frames_.back());
}

// Sets the pose of the frame and whether it is ok. False where the frame is rejected and none was ever determined.
bool Odometry::locate(TrackedFrame& frame, const Features& features, const Run& run) {
  motion_covariance_.setZero();
  found_again_after_s_ = 0;
  doubt_ = 0;
  bent_ = false;
  unsettled_ = false;
  joined_ = false;
  found_state_.reset();
  expected_ = filter_ ? filter_->predict(frame.begin_s, frame.end_s) : std::nullopt;
  const FrameMotion prediction = expected_ ? expected_->motion : predicted(frame.begin_s, frame.end_s);
  frame.motion = prediction;
  if (features.query.size() < min_features) {
    frame.ok = false;
    why_failed_ = "only " + std::to_string(features.query.size()) + " usable points";
    return true;
  }
  Stopwatch watch;
  const FrameMotion guess = guessed(prediction, frame.begin_s, frame.end_s, features, run);
  times_.guess_s += watch.lap();
  Registration r = registered(prediction, guess, frame.begin_s, frame.end_s, features, run);
  times_.register_s += watch.lap();
  const auto seen = observability(features.query, local_map_.maps(), r.motion, base_settings(), run, std::move(r.met));
  auto open = open_motion(r, seen);
  if (joined_) open = bridged_motion(r, open, seen, guess, frame, features, run);
  frame.sigma0 = r.sigma0;
  frame.covariance = r.covariance;
  frame.end_covariance = r.end_covariance;
  frame.overlap = r.overlap;
  frame.rms = r.rms;
  frame.iterations = r.iterations;
  frame.conditioning = r.conditioning;
  frame.converged = r.converged;
  frame.bent = bent_;
  frame.observability = seen.weakest;
  frame.spread = seen.spread;
  frame.unfaced_axis = seen.unfaced_axis;
  const auto why = objection(r, open, prediction, frame.begin_s, frame.end_s);
  times_.judge_s += watch.lap();
  frame.ok = why.empty();
  if (frame.ok) {
    frame.motion = {orthonormal(r.motion.T_map_begin), orthonormal(r.motion.T_map_end), r.motion.shape};
    return true;
  }
  why_failed_ = why;
  return held_ || !(why == open || !open_at_start_.empty());
}

bool Odometry::keyframe_due(const TrackedFrame& frame) const {
  // In foliage the objects of a single frame give few lines, so the first frames at rest make the map together.
  if (settings_.features == FeatureKind::ground && keyframes_.size() < first_keyframes) return true;
  const Pose d = keyframes_.back().T_map_keyframe.inverse() * frame.motion.T_map_end;
  return d.translation().norm() >= settings_.keyframe_distance ||
         Eigen::AngleAxisd(d.linear()).angle() >= radians(settings_.keyframe_angle_deg);
}

void Odometry::add_keyframe(const Features& features, const TrackedFrame& frame) {
  keyframes_.push_back(make_keyframe(frames_.size() - 1, frame.end_s, features.map, frame.motion));
  keyframes_.back().travelled = travelled_;
  local_map_.update(keyframes_, frame.motion.T_map_end.translation());
  if (frames_.size() == 1) remember_frame(frame, features);
}

void Odometry::drop_failed_tail() {
  while (!frames_.empty() && !frames_.back().ok) frames_.pop_back();
  while (!keyframes_.empty() && keyframes_.back().frame >= frames_.size()) keyframes_.pop_back();
  failed_in_a_row_ = 0;
}

}  // namespace bole::slam
