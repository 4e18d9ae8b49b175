// Odometry: registers frame after frame against a local map of keyframes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam/core/inertial/inertial_filter.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/odometry/observability.h"
#include "slam/core/options.h"

namespace bole::slam {

class PointMatches;

// A carrier that walks bends the motion within a longer frame by more than a centimetre.
inline constexpr double longest_straight_frame_s = 0.15;

struct TrackedFrame {
  std::size_t index = 0;  // in the source
  double begin_s = 0, end_s = 0;
  FrameMotion motion;
  std::size_t keyframe = 0;  // the last keyframe up to and with this frame
  bool ok = true;
  double overlap = 1, rms = 0;
  double conditioning = 1;   // see Registration
  double observability = 1;  // see Observability; unknown where `iterations` is 0
  double spread = 1;         // see Observability
  Eigen::Vector2d unfaced_axis = Eigen::Vector2d::Zero();
  double sigma0 = 0;                           // of the last adjustment, see Registration
  Matrix6d covariance = Matrix6d::Zero();      // of the pose; zero for the first frame, which is exact
  Matrix6d end_covariance = Matrix6d::Zero();  // see Registration
  int iterations = 0;
  bool converged = true;  // see Registration; the first frame is not registered
  bool bent = false;      // did not move as assumed for de-skewing; begin and end were fitted, see register_bent()
  bool joined = false;    // registered together with the inertial unit
  double tension = 0;     // between the inertial unit and the points, see InertialFilter::tension()
  bool bridged = false;   // the inertial unit led over a motion that the surroundings leave open, or over the frame
  double mid_s() const { return 0.5 * (begin_s + end_s); }
};

struct OdometryTimes {
  double guess_s = 0, register_s = 0, judge_s = 0, map_s = 0;
};

class Odometry {
 public:
  // With an inertial unit its measurements predict each frame, shape the motion within it, and are the prior of its
  // registration. The map is then level from the start.
  explicit Odometry(const SlamSettings& settings, const InertialUnit* unit = nullptr);
  ~Odometry();

  // Adds a frame. A frame that does not agree with the map is kept with its predicted motion and marked as not ok; see
  // lost().
  void add(std::size_t index, double begin_s, double end_s, const Features& features, const Run& run);

  const std::vector<TrackedFrame>& frames() const { return frames_; }
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  // Sets the scan context of the last keyframe.
  void set_context(ScanContext context) { keyframes_.back().context = std::move(context); }
  std::vector<TrackedFrame> take_frames() { return std::move(frames_); }
  std::vector<Keyframe> take_keyframes() { return std::move(keyframes_); }
  const OdometryTimes& times() const { return times_; }

  // Whether too many consecutive frames failed.
  bool lost() const { return failed_in_a_row_ >= settings_.lost_frames; }
  std::size_t failed_in_a_row() const { return static_cast<std::size_t>(failed_in_a_row_); }
  const std::string& why_failed() const { return why_failed_; }
  // Time between the last frame and the last good one before it, when the sensor had to be found again; else 0.
  double found_again_after_s() const { return found_again_after_s_; }
  double doubt() const { return doubt_; }  // see Relocalisation

  // The state at the last frame; null without an inertial unit, or before it could start.
  const InertialState* inertial() const { return filter_ && filter_->started() ? &filter_->state() : nullptr; }

  // Call after the last frame. A walk that never had a well-determined frame is withdrawn, see open_motion().
  void finish();

  // Removes the failed frames at the end, and the keyframes made since the last good one.
  void drop_failed_tail();

 private:
  bool elastic() const { return settings_.deskew == Deskew::elastic; }
  FrameMotion predicted(double begin_s, double end_s) const;
  bool known_by_its_middle(const TrackedFrame& frame) const;
  Vector6d mean_velocity(double over_s) const;
  RegistrationSettings base_settings() const;
  void hold_to_gait(RegistrationSettings& settings, double gap_s) const;
  FrameMotion with_speed_found(const FrameMotion& found, double begin_s, double end_s) const;
  FrameMotion guessed(const FrameMotion& prediction, double begin_s, double end_s, const Features& features,
                      const Run& run);
  FrameMotion matched_motion(const FrameMotion& prediction, double begin_s, const Features& features, const Run& run);
  void remember_frame(const TrackedFrame& frame, const Features& features);
  FrameMotion motion_found(const FrameMotion& found, double begin_s, double end_s) const;
  // `prediction`: as if the carrier went on as before; `guess`: where the registration begins, see guessed().
  Registration registered(const FrameMotion& prediction, const FrameMotion& guess, double begin_s, double end_s,
                          const Features& features, const Run& run);
  Registration followed(const FrameMotion& prediction, const FrameMotion& guess, double begin_s, double end_s,
                        const Features& features, const Run& run);
  Registration unbent(Registration r, const FrameMotion& found, const FrameMotion& assumed, const Features& features,
                      const Run& run);
  Registration searched(double begin_s, double end_s, const Features& features, const Run& run);
  const TrackedFrame& last_good() const { return frames_[last_good_]; }
  double usual_overlap() const;
  double min_overlap() const;
  bool is_suspect(const Registration& r, const FrameMotion& assumed, const FrameMotion& found) const;
  double recent_observability(double of_this_frame) const;
  void withdraw_start();
  void start_inertial(TrackedFrame& frame);
  bool can_be_followed(double begin_s) const;
  void join_inertial(RegistrationSettings& settings) const;
  InertialState found_state(const Registration& r) const;
  std::string bridged_motion(Registration& r, const std::string& open, const Observability& seen,
                             const FrameMotion& guess, TrackedFrame& frame, const Features& features, const Run& run);
  void confirm_rest(const TrackedFrame& frame);
  void settle_inertial(TrackedFrame& frame);
  void add_first(TrackedFrame frame, const Features& features);
  bool locate(TrackedFrame& frame, const Features& features, const Run& run);
  // Why the frame is rejected; empty when it is credible.
  std::string objection(const Registration& r, const std::string& open, const FrameMotion& prediction, double begin_s,
                        double end_s) const;
  std::string open_motion(
      const Registration& r,
      const Observability& seen);  // the open motion; empty when there is none, or when it is not judged yet
  std::string doubt_text() const;  // empty when the place that was found is unambiguous
  void add_keyframe(const Features& features, const TrackedFrame& frame);
  bool keyframe_due(const TrackedFrame& frame) const;

  const SlamSettings settings_;
  std::vector<TrackedFrame> frames_;
  std::vector<Keyframe> keyframes_;
  LocalMap local_map_;
  FeatureMaps last_frame_map_;
  std::unique_ptr<PointMatches> last_frame_points_;
  Matrix6d motion_covariance_ = Matrix6d::Zero();  // of the first guess for the current frame
  std::optional<InertialFilter> filter_;
  // Of the current frame: what the inertial unit expects, the motions that its points determine, whether the
  // expectation was its prior, and the state that follows from its registration.
  std::optional<InertialFilter::Prediction> expected_;
  std::optional<Matrix6d> determined_;
  bool joined_ = false;
  std::optional<InertialState> found_state_;
  std::optional<double> rest_from_s_;  // the unit measured rest or steady motion from there; not confirmed yet
  double travelled_ = 0;
  std::size_t last_good_ = 0;
  int failed_in_a_row_ = 0;
  bool doubted_ = false;                        // since the last good frame
  std::size_t left_start_ = 0;                  // the first frame outside the place of the start; 0 when there is none
  bool held_ = false;                           // at least once, no motion was open
  std::string open_at_start_;                   // the open motion of frames that were let pass, see open_motion()
  bool bent_ = false, unsettled_ = false;       // of the current frame, see unbent()
  double found_again_after_s_ = 0, doubt_ = 0;  // of the current frame, see Relocalisation
  std::string why_failed_;
  OdometryTimes times_;
};

}  // namespace bole::slam
