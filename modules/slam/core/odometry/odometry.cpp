#include "slam/core/odometry/odometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/core/odometry/observability.h"
#include "slam/core/odometry/relocalise.h"
#include "slam/core/odometry/unbend.h"
#include "slam/core/stopwatch.h"

namespace bole::slam {
namespace {

constexpr double rad(double deg) { return deg * std::numbers::pi / 180; }
constexpr std::size_t least_features = 100;
constexpr double start_keyframes = 3;        // as far as these lie apart reaches the first place, see open_motion
constexpr double least_at_start = 0.5;       // of the observability asked later; plots have 0.7 and more, fields 0.2
constexpr std::size_t first_keyframes = 6;   // of a map of the ground
constexpr double least_conditioning = 2e-4;  // a forest plot has 0.05 to 0.5, vine rows over much ground a thousandth
constexpr std::size_t usual_frames = 20;
constexpr double least_share_of_usual = 0.5;  // of the overlap of the frames before
// See Relocalisation; once two places were alike, the next frames are asked for more, for chance has several of them.
constexpr double most_doubt = 0.5, most_doubt_again = 0.25;
// See is_suspect and unbent. Walking, the motion that de-skews a frame is off by up to 2 deg.
constexpr double most_bend_rad = rad(3), most_apart_m = 0.2;
constexpr double least_sure = 0.9, least_settled = 0.85;  // of the usual overlap
constexpr double sure_overlap = 0.6;                      // below it a rigid frame is looked for farther away as well

// A walking person changes speed by up to about 0.4 m/s and turn rate by about 0.2 rad/s from one tenth of a second to
// the next.
constexpr double stride_s = 1.05;        // two steps
constexpr double longest_join_s = 0.15;  // frames farther apart than this have a gap between them
constexpr double gait_acceleration_m_s2 = 4, gait_turn_acceleration_rad_s2 = 2;

// Each pose is made from the one before; without this the rotations stop being rotations after a hundred frames or so.
Pose orthonormal(Pose T) {
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

std::string percent(double share) { return number_text(std::round(share * 100)) + " %"; }

}  // namespace

Odometry::Odometry(const SlamOptions& resolved_options)
    : options_(resolved_options),
      local_map_(resolved_options.cell_m, static_cast<std::size_t>(resolved_options.neighbour_keyframes),
                 resolved_options.local_map == "last"),
      last_frame_map_(2 * resolved_options.cell_m) {}

// Constant velocity from the last good frame. Over a gap the mean motion of the last stride holds better than that of
// one moment of the gait.
FrameMotion Odometry::predicted(double begin_s, double end_s) const {
  if (frames_.empty()) return {};
  const auto& last = last_good();
  const double last_span_s = last.end_s - last.begin_s, gap_s = std::max(0.0, begin_s - last.end_s);
  if (last_good_ == 0 || last_span_s <= 0) return {last.motion.T_map_end, last.motion.T_map_end};
  Vector6d velocity =
      elastic() ? Vector6d(se3_log(last.motion.delta()) / last_span_s) : mean_velocity(0.5 * last_span_s);
  if (gap_s > longest_join_s) velocity = mean_velocity(stride_s);
  if (!elastic()) {
    const double ahead_s = std::min(0.5 * (begin_s + end_s) - last.mid_s(), 1.5);
    return motion_about(last.motion.at(0.5) * se3_exp(velocity * ahead_s), velocity, end_s - begin_s);
  }
  FrameMotion out;
  out.T_map_begin = last.motion.T_map_end * se3_exp(velocity * std::min(gap_s, 1.5));
  out.T_map_end = out.T_map_begin * se3_exp(velocity * (end_s - begin_s));
  return out;
}

// From the good frame at least `over_s` before the last good one. A rigid shift of a frame settles where its middle is;
// begin and end hang on the motion that was assumed within it, and a velocity taken from them feeds its own error back
// with changed sign: it swings. So rigid frames are compared by their middles.
Vector6d Odometry::mean_velocity(double over_s) const {
  if (last_good_ == 0) return Vector6d::Zero();
  const auto& last = last_good();
  std::size_t k = last_good_ - 1;
  while (k > 0 && (!frames_[k].ok || last.end_s - frames_[k].end_s < over_s)) --k;
  const auto& first = frames_[k];
  if (elastic()) return se3_log(first.motion.T_map_end.inverse() * last.motion.T_map_end) / (last.end_s - first.end_s);
  return se3_log(first.motion.at(0.5).inverse() * last.motion.at(0.5)) / (last.mid_s() - first.mid_s());
}

// The motion over a frame of which a registration has found the middle, at the speed since the middle of the last
// frame.
FrameMotion Odometry::with_speed_found(const FrameMotion& found, double begin_s, double end_s) const {
  const auto& last = last_good();
  const double since_s = 0.5 * (begin_s + end_s) - last.mid_s();
  if (since_s <= 0 || begin_s - last.end_s > longest_join_s) return found;
  const Pose T_map_mid = found.at(0.5);
  return motion_about(T_map_mid, se3_log(last.motion.at(0.5).inverse() * T_map_mid) / since_s, end_s - begin_s);
}

// LOAM's two steps: against the frame before for the motion, against the map (registered()) for the place.
FrameMotion Odometry::guessed(const FrameMotion& prediction, double begin_s, double end_s, const Features& features,
                              const Run& run) {
  if (options_.deskew == "none") return {prediction.at(0.5), prediction.at(0.5)};
  if (options_.first_guess != "last_frame") return prediction;
  auto settings = base_settings();
  const auto& last = last_good();
  if (settings.priors) {
    // De-skewing takes the priors of all points; those of the first frame have an exact pose.
    settings.priors->reference_points = true;
    settings.priors->reference_covariance = last.covariance;
    settings.priors->reference_position = last.motion.T_map_end.translation();
  }
  const auto r = register_frame(features.query, last_frame_map_, prediction, settings, run);
  if (r.overlap < options_.lost_overlap || r.conditioning < least_conditioning) return prediction;
  motion_covariance_ = r.covariance;
  return with_speed_found(r.motion, begin_s, end_s);
}

// Priors of the motion over a frame that follows the last one after a gap.
void Odometry::hold_to_gait(RegistrationSettings& settings, double gap_s) const {
  const double span_s = std::max(0.02, last_good().end_s - last_good().begin_s), changed_s = std::max(span_s, gap_s);
  settings.begin_sigma_m = options_.continuity_sigma_m + gait_acceleration_m_s2 * gap_s * changed_s;
  settings.begin_sigma_rad = rad(options_.continuity_sigma_deg) + gait_turn_acceleration_rad_s2 * gap_s * changed_s;
  settings.motion_sigma_m = gait_acceleration_m_s2 * span_s * changed_s;
  settings.motion_sigma_rad = gait_turn_acceleration_rad_s2 * span_s * changed_s;
}

RegistrationSettings Odometry::base_settings() const {
  RegistrationSettings settings;
  settings.rounds = options_.rounds;
  settings.sigma_m = options_.range_sigma_m;
  settings.kernel_sigmas = options_.kernel_sigmas;
  settings.two_step = options_.solve == "two_step";
  if (options_.weights == "priors")
    settings.priors = AdjustmentPriors{.sensor = {options_.range_sigma_m, rad(options_.angle_sigma_deg)},
                                       .motion_covariance = motion_covariance_};
  return settings;
}

// Where the sensor is expected; where that does not fit, or nothing can be expected after a gap, anywhere that it can
// have got to.
Registration Odometry::registered(const FrameMotion& guess, double begin_s, double end_s, const Features& features,
                                  const Run& run) {
  Registration r;
  if (begin_s - last_good().end_s <= longest_join_s) {
    r = followed(guess, begin_s, end_s, features, run);
    if (r.overlap >= least_overlap()) return r;
  }
  Registration again = searched(begin_s, end_s, features, run);
  if (again.overlap <= r.overlap) return r;
  found_again_after_s_ = begin_s - last_good().end_s;
  // A frame that was out of its place for its own bend, and no gap, is found in wrong places as well.
  unsettled_ = options_.deskew == "once" && again.overlap < least_sure * usual_overlap();
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

Registration Odometry::followed(const FrameMotion& guess, double begin_s, double end_s, const Features& features,
                                const Run& run) {
  RegistrationSettings settings = base_settings();
  if (elastic()) {
    settings.model = MotionModel::elastic;
    hold_to_gait(settings, std::max(0.0, begin_s - last_good().end_s));
    return register_frame(features.query, local_map_.maps(), guess, settings, run);
  }
  settings.model = MotionModel::rigid;
  auto r = register_frame(features.query, local_map_.maps(), guess, settings, run);
  if (r.overlap < sure_overlap) {
    // A sudden turn leaves the prediction behind. Search wider, from the prediction and from where the sensor was.
    settings.coarse_rounds = 8;
    settings.rounds = options_.rounds + 8;
    const Pose& T_map_last = last_good().motion.T_map_end;
    for (const auto& from : {guess, FrameMotion{T_map_last, T_map_last}}) {
      auto wider = register_frame(features.query, local_map_.maps(), from, settings, run);
      if (wider.overlap > r.overlap) r = std::move(wider);
    }
    settings = base_settings();
  }
  if (options_.deskew == "none") return r;
  if (options_.deskew == "twice") {
    // SPEC A5: the motion that was found replaces the guess, and the raw frame is registered again.
    settings.coarse_rounds = 0;
    if (settings.priors) settings.priors->motion_covariance = r.covariance + last_good().covariance;
    r = register_frame(features.query, local_map_.maps(), with_speed_found(r.motion, begin_s, end_s), settings, run);
  }
  const FrameMotion found = with_speed_found(r.motion, begin_s, end_s);
  if (options_.deskew == "once" && is_suspect(r, guess, found)) return unbent(r, found, guess, features, run);
  r.motion = found;
  return r;
}

// `r` again with begin and end fitted where the frame is bent. Where that does not settle either, or elsewhere, nothing
// tells where the frame was.
Registration Odometry::unbent(Registration r, const FrameMotion& found, const FrameMotion& assumed,
                              const Features& features, const Run& run) {
  const double least = least_settled * usual_overlap();
  auto fitted = register_bent(features.query, local_map_.maps(), assumed, base_settings(), run);
  if (bend_rad(assumed, fitted.motion) > most_bend_rad && fitted.overlap > r.overlap) {
    bent_ = true;
    unsettled_ = !fitted.converged && fitted.overlap < least;
    return fitted;
  }
  const double apart_m = (fitted.motion.at(0.5).translation() - r.motion.at(0.5).translation()).norm();
  unsettled_ = !r.converged && r.overlap < least && (!fitted.converged || apart_m > most_apart_m);
  r.motion = found;
  return r;
}

// The median of the good frames before; 0 where there are too few.
double Odometry::usual_overlap() const {
  std::vector<double> before;
  for (std::size_t k = frames_.size(); before.size() < usual_frames && k-- > 1;)
    if (frames_[k].ok) before.push_back(frames_[k].overlap);
  if (before.size() < 5) return 0;
  const auto middle = before.begin() + static_cast<std::ptrdiff_t>(before.size() / 2);
  std::ranges::nth_element(before, middle);
  return *middle;
}

// A frame that agrees much less than those before it is in a wrong place, even where a quarter of its points, most of
// them ground, happens to agree.
double Odometry::least_overlap() const {
  return std::max(options_.lost_overlap, least_share_of_usual * usual_overlap());
}

// Whether a frame may be bent by a motion that it was de-skewed with and did not have. It does not show in the motion
// that is found, for a bent frame settles near the assumption; it shows in that it hardly settles, or agrees less.
bool Odometry::is_suspect(const Registration& r, const FrameMotion& assumed, const FrameMotion& found) const {
  return !r.converged || r.overlap < least_sure * usual_overlap() || bend_rad(assumed, found) > most_bend_rad;
}

// One sparse frame may look open by chance; surroundings that are open stay so. So the last frames speak together, by
// their geometric mean. The first frame has nothing to be seen against, empty ones were not registered, and those of
// the first place (see open_motion) say nothing of what comes after it.
double Odometry::recent_observability(double of_this_frame) const {
  constexpr std::size_t most = 4;
  double sum = std::log(std::max(of_this_frame, 1e-6));
  std::size_t n = 1;
  for (std::size_t k = frames_.size(); n < most && k-- > std::max<std::size_t>(1, left_start_);)
    if (frames_[k].rounds > 0) sum += std::log(std::max(frames_[k].observability, 1e-6)), ++n;
  return std::exp(sum / static_cast<double>(n));
}

// At rest the map is one frame, seen again on the very same lines: they tell little about a shift across them, even in
// a plot, and so it goes on for the first steps. So motions that are not quite held are let pass until the sensor has
// left its first place. Where nothing gets hold of it before that, as in a corridor, which it may leave without being
// seen to, or where it comes to a motion that cannot be, all of that is withdrawn.
std::string Odometry::open_motion(const Registration& r, const Observability& seen) {
  const std::string text = "the surroundings leave a direction of motion open: " + seen.motion_text();
  if (r.conditioning < least_conditioning) return text;
  const double way_m = (r.motion.T_map_end.translation() - keyframes_.front().T_map_keyframe.translation()).norm();
  if (left_start_ == 0 && way_m >= start_keyframes * options_.keyframe_distance_m) left_start_ = frames_.size();
  const double recent = recent_observability(seen.weakest);
  if (recent >= options_.least_observability) {
    held_ |= r.overlap >= least_overlap();
    return {};
  }
  if (left_start_ > 0 || recent < least_at_start * options_.least_observability) return text;
  open_at_start_ = text;
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
  if (const double least = least_overlap(); r.overlap < least)
    return "only " + percent(r.overlap) + " of " + std::to_string(r.tried) + " points agree with the map, " +
           percent(least) + " are needed";
  if (!r.motion.T_map_end.matrix().allFinite() || !r.motion.T_map_begin.matrix().allFinite())
    return "the solution is not finite";
  const double speed =
      (r.motion.T_map_end.translation() - r.motion.T_map_begin.translation()).norm() / std::max(0.02, end_s - begin_s);
  if (speed > options_.speed_max_m_s) return "the motion would be " + number_text(std::round(speed * 10) / 10) + " m/s";
  if (!open.empty()) return open;
  if (unsettled_)
    return "the frame does not settle: " + percent(r.overlap) + " of its points agree with the map after " +
           std::to_string(r.rounds) + " rounds, " + percent(usual_overlap()) + " did before";
  const double elapsed_s = end_s - last_good().end_s;
  const double leap_m = (r.motion.T_map_end.translation() - prediction.T_map_end.translation()).norm();
  if (leap_m > 0.3 + options_.speed_max_m_s * elapsed_s)
    return "the pose would leap by " + number_text(std::round(leap_m * 100) / 100) + " m";
  return doubt_text();
}

std::string Odometry::doubt_text() const {
  if (found_again_after_s_ <= 0 || doubt_ <= (doubted_ ? most_doubt_again : most_doubt)) return {};
  return "two places fit alike " + number_text(std::round(found_again_after_s_ * 10) / 10) +
         " s after the last good frame, with odds of " + number_text(std::round(100 * doubt_) / 100) + " to 1";
}

void Odometry::add(std::size_t index, double begin_s, double end_s, const Features& features, const Run& run) {
  TrackedFrame frame;
  frame.index = index, frame.begin_s = begin_s, frame.end_s = end_s;
  if (frames_.empty()) {
    if (features.query.size() < least_features) return;  // nothing to start a map from
    frames_.push_back(frame);
    add_keyframe(features, frames_.back());
    return;
  }

  Stopwatch watch;
  bool never_held = false;
  motion_covariance_.setZero();
  found_again_after_s_ = doubt_ = 0;
  bent_ = unsettled_ = false;
  const FrameMotion prediction = predicted(begin_s, end_s);
  frame.motion = prediction;
  if (features.query.size() < least_features) {
    frame.ok = false;
    why_failed_ = "only " + std::to_string(features.query.size()) + " usable points";
  } else {
    const FrameMotion guess = guessed(prediction, begin_s, end_s, features, run);
    times_.guess_s += watch.lap_s();
    const Registration r = registered(guess, begin_s, end_s, features, run);
    times_.register_s += watch.lap_s();
    frame.sigma0 = r.sigma0, frame.covariance = r.covariance;
    frame.overlap = r.overlap, frame.rms_m = r.rms_m, frame.rounds = r.rounds, frame.conditioning = r.conditioning;
    frame.converged = r.converged, frame.bent = bent_;
    const auto seen = observability(features.query, local_map_.maps(), r.motion, base_settings(), run);
    frame.observability = seen.weakest;
    const auto open = open_motion(r, seen);
    const auto why = objection(r, open, prediction, begin_s, end_s);
    never_held = !why.empty() && !held_ && (why == open || !open_at_start_.empty());
    times_.judge_s += watch.lap_s();
    frame.ok = why.empty();
    if (frame.ok)
      frame.motion = {orthonormal(r.motion.T_map_begin), orthonormal(r.motion.T_map_end)};
    else
      why_failed_ = why;
  }
  failed_in_a_row_ = frame.ok ? 0 : failed_in_a_row_ + 1;
  path_m_ += (frame.motion.T_map_end.translation() - frames_.back().motion.T_map_end.translation()).norm();
  frames_.push_back(frame);
  if (frame.ok) last_good_ = frames_.size() - 1;
  if (never_held) withdraw_start();
  doubted_ = !frame.ok && (doubted_ || why_failed_ == doubt_text());
  watch.lap_s();
  if (frame.ok && keyframe_due(frame)) add_keyframe(features, frames_.back());
  frames_.back().keyframe = keyframes_.size() - 1;
  if (frame.ok && options_.first_guess == "last_frame") {
    last_frame_map_.clear();
    insert_keyframe(make_keyframe(index, end_s, features.map, frame.motion), last_frame_map_);
  }
  times_.map_s += watch.lap_s();
}

bool Odometry::keyframe_due(const TrackedFrame& frame) const {
  // Of a leafy place the things of a single frame give few lines: at rest the first frames make the map together.
  if (options_.features == "ground" && keyframes_.size() < first_keyframes) return true;
  const Pose d = keyframes_.back().T_map_keyframe.inverse() * frame.motion.T_map_end;
  return d.translation().norm() >= options_.keyframe_distance_m ||
         Eigen::AngleAxisd(d.linear()).angle() >= rad(options_.keyframe_angle_deg);
}

void Odometry::add_keyframe(const Features& features, const TrackedFrame& frame) {
  keyframes_.push_back(make_keyframe(frames_.size() - 1, frame.end_s, features.map, frame.motion));
  keyframes_.back().path_m = path_m_;
  local_map_.update(keyframes_, frame.motion.T_map_end.translation());
  if (frames_.size() == 1 && options_.first_guess == "last_frame") insert_keyframe(keyframes_.back(), last_frame_map_);
}

void Odometry::drop_failed_tail() {
  while (!frames_.empty() && !frames_.back().ok) frames_.pop_back();
  while (!keyframes_.empty() && keyframes_.back().frame >= frames_.size()) keyframes_.pop_back();
  failed_in_a_row_ = 0;
}

}  // namespace bole::slam
