// The walk of the scanner against the track of a GNSS receiver that was carried along.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cloud/trajectory.h"

namespace bole::survey {

struct TrackFix {
  double time_s = 0;                                 // clock of the receiver
  Eigen::Vector3d global = Eigen::Vector3d::Zero();  // easting, northing, height; height NaN where it is not known
  double sd_m = 1;  // of easting and northing beside other fixes; only the ratios matter; of the height twice as large
};

struct TrackPrior {
  Eigen::Vector3d lever_sensor = Eigen::Vector3d::Zero();  // from the sensor to the antenna, in sensor axes
  double lever_sd_m = 0.3;                                 // of each axis
};

struct TrackFit {
  double turn_rad = 0;  // counter-clockwise from local to global axes
  Eigen::Vector3d centre_local = Eigen::Vector3d::Zero(), centre_global = Eigen::Vector3d::Zero();
  bool heights = false;                                    // centre_global.z was adjusted
  double clock_offset_s = 0;                               // time of the trajectory - time of the receiver
  Eigen::Vector3d lever_sensor = Eigen::Vector3d::Zero();  // as TrackPrior
  // Standard errors. Neighbouring fixes err alike: `fixes_per_independent` of them count as one.
  double turn_se_rad = 0, shift_se_m = 0, height_se_m = 0, clock_offset_se_s = 0;
  Eigen::Vector3d lever_se_m = Eigen::Vector3d::Zero();
  double fixes_per_independent = 1;
  double residual_m = 0;  // robust standard deviation of easting and northing
  double outliers = 0;    // share of fixes that hardly count
  std::size_t fixes = 0;  // that have a pose
  double extent_m = 0;    // of the walk in the plan
};

struct ClockOffsetFound {
  double offset_s = 0;  // time of the trajectory - time of the receiver
  double misfit_m = 0;  // median distance after turn and shift
  // Another offset that fits alike, with a shorter overlap of the recordings.
  std::optional<double> rival_s{};
};

// The offset between the clocks at which the track has the shape of the walk, to about a second: every offset in
// `candidates_s` +- `window_s` is tried, or where none is plausible every one with which half of the shorter recording
// overlaps. Of offsets that fit alike the one with the longest overlap is taken: parallel lines look alike when they
// are shifted by two. Throws Error{bad_input} where there is none, and where two offsets far apart fit and overlap
// alike.
ClockOffsetFound find_clock_offset(const Trajectory& walk, const std::vector<TrackFix>& track,
                                   const std::vector<double>& candidates_s, double window_s);

// Offsets that clocks of receivers and recorders have: none, days (receivers that send the time of day), leap seconds.
std::vector<double> usual_clock_offsets(const Trajectory& walk, const std::vector<TrackFix>& track);

// Robust least squares (Cauchy weights) for turn, shift, offset of the clocks and lever arm:
// global = centre_global + Rz(turn) (p(t + offset) + R(t + offset) lever - centre_local). The lever arm is an
// observation too. Throws Error{bad_input} for fewer than 20 fixes with a pose.
TrackFit fit_track(const Trajectory& walk, const std::vector<TrackFix>& track, double clock_offset_s,
                   const TrackPrior& prior);

}  // namespace bole::survey
