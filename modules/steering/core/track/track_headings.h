// The heading of a vehicle at its fixes, from whatever a log holds.
#pragma once

#include <vector>

#include "cloud/table.h"
#include "geo/core/attitude.h"
#include "steering/core/track/navigate_track.h"

namespace bole::steering {

// A fix of the antenna, after the bad ones are gone; times rise within a segment.
struct AntennaFix {
  std::size_t row = 0;  // of the track
  double time_s = 0;
  Eigen::Vector2d antenna_nav = Eigen::Vector2d::Zero();
  double sigma_m = 0;
  std::int64_t quality = -1, run = 1, segment = 1;
};

struct TrackAttitudes {
  std::vector<geo::Attitude> at;  // yaw is NaN where nothing gives it
  std::size_t measured = 0, by_course = 0, by_motion = 0, without_heading = 0;
  bool tilt_known = false;
};

// Attitude at every fix. Measured headings and courses are counted from true north and brought to the plane by its
// convergence. A course counts from 0.5 m/s; below that the last heading is kept. The direction of motion is taken over
// a metre. A vehicle that reverses is not told from one that turned round, unless its heading is measured.
TrackAttitudes attitudes_of(const std::vector<AntennaFix>& fixes, const Table& track, const Table* attitude,
                            const NavigateOptions& options);

}  // namespace bole::steering
