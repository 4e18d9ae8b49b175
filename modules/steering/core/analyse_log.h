// Lines in a recorded track, and how straight and how evenly apart they were driven (the analysis of SPEC E5).
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "steering/core/steering_options.h"

namespace bole::steering {

struct LogAnalysis {
  Table passes;  // pass, angle_deg (of the way driven, to east), x0_m, y0_m, x1_m, y1_m, length_m, speed_km_h (NaN
                 // without times), line_mean_m, line_sd_m, line_max_m (about its own line), neighbour (pass; 0: none),
                 // distance_m (to it), adjacent_mean_m, adjacent_sd_m, adjacent_max_m
  Table errors;  // pass, station_m, x_m, y_m, error_m, adjacent_m
  Report report;
};

// `track` has x_m, y_m, and time_s where speeds are wanted. A pass is a straight stretch; its line is that of least
// squares; the neighbour is the nearest earlier parallel pass. Throws Error{bad_input} without positions.
LogAnalysis analyse_log(const Table& track, const LogOptions& options, const Run& run);

// Positions of a track through the position-velocity filter: the table with x_m, y_m replaced by the filter's, and the
// columns vx_m_s, vy_m_s and used (0: beyond the gate). Needs time_s, x_m, y_m.
struct FilteredTrack {
  Table track;
  Report report;
};
FilteredTrack filter_track(const Table& track, const FilterOptions& options, const Run& run);

}  // namespace bole::steering
