// Recorded fixes of a receiver brought to the control point of the vehicle and filtered (SPEC E2, E3).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"

namespace bole::steering {

// Where the heading comes from that turns the lever arm. automatic: measured, else course, else motion.
enum class HeadingSource { automatic, measured, course, motion };
constexpr std::array<std::string_view, 4> choice_names(HeadingSource) {
  return {"auto", "measured", "course", "motion"};
}

struct NavigateOptions {
  double antenna_forward = 0;
  double antenna_left = 0;
  double antenna_up = 0;
  HeadingSource heading = HeadingSource::automatic;
  double heading_offset_deg = 0;
  std::string accept = "1 2 3 4 5 9";
  std::optional<double> position_sigma;
  double acceleration_sigma = 0.3;
  double gate = 5;
  double patience = 2;
  double max_gap = 5;
};
const OptionTable& option_table(const NavigateOptions*);

struct NavigatedTrack {
  // A row per accepted fix: time_s, x_m, y_m of the control point (filtered), x_se_m, y_se_m as the filter believes,
  // gnss_x_m, gnss_y_m (control point by this fix alone), antenna_x_m, antenna_y_m, yaw_deg (from east to north; NaN
  // where it is unknown), speed_m_s, quality (-1: the track has none), sigma_m of the fix, segment (from 1: a gap
  // starts a new one), state (used, doubted). A column run is kept. Facts of the track go with it.
  Table log;
  Report report;
};

// `track`: time_s, x_m, y_m; where known quality (GGA), sd_east_m and sd_north_m, heading_deg and course_deg (from true
// north), convergence_deg of the plane, speed_m_s, run. `attitude`: time_s and any of roll_deg, pitch_deg
// (geo::Attitude) and heading_deg or yaw_deg (from east to north in the plane). Fixes that are left out are counted by
// reason; what makes the result doubtful is a finding. Throws Error{bad_input} when columns are missing, no fix is
// accepted, or the lever arm needs a heading that nothing gives; Error{cancelled}.
NavigatedTrack navigate_track(const Table& track, const Table* attitude, const NavigateOptions& options,
                              const Run& run);

}  // namespace bole::steering
