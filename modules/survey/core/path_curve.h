// The places of a sensor as a smooth curve through the poses of a trajectory: cubic between poses, with velocities from
// the neighbouring ones. Straight lines between poses of 10 Hz would cut the crests of a walking gait by millimetres.
#pragma once

#include <optional>
#include <vector>

#include "cloud/trajectory.h"

namespace bole::survey {

class PathCurve {
 public:
  // Poses further apart than `max_gap_s` are not connected.
  PathCurve(const Trajectory& trajectory, double max_gap_s);

  double begin_s() const { return places_.front().time_s; }
  double end_s() const { return places_.back().time_s; }

  // Nothing before the first pose, after the last one and within gaps.
  std::optional<Eigen::Vector3d> at(double time_s) const;
  // The same, with the nearest pose where there is nothing.
  Eigen::Vector3d nearest(double time_s) const;

 private:
  struct Place {
    double time_s = 0;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
  };
  Eigen::Vector3d velocity(std::size_t i) const;

  std::vector<Place> places_;
  double max_gap_s_;
};

}  // namespace bole::survey
