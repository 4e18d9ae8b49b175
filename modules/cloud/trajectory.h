// A sensor's path: poses with times.
#pragma once

#include <string>
#include <vector>

#include "base/transform.h"
#include "cloud/facts.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

struct StampedPose {
  double time_s = 0;
  Pose T_target_sensor = Pose::Identity();  // target: the axes of the trajectory (map or plot)
};

struct Trajectory {
  std::vector<StampedPose> poses;  // times strictly increase
  Axes axes = Axes::map;
  Facts facts;

  bool empty() const { return poses.empty(); }
  // The pose at a time, interpolated on the manifold; held constant in velocity for up to `max_extrapolation_s` beyond
  // the ends. Throws Error{bad_input} further out or when there are fewer than two poses.
  Pose at(double time_s, double max_extrapolation_s = 0.2) const;
  double length_m() const;
};

}  // namespace cloud
}  // namespace bole
