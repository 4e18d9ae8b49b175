// Finds the sensor again in the map after a gap in the recording or after frames that did not fit.
#pragma once

#include "slam/core/odometry/registration.h"

namespace bole::slam {

struct LastSeen {
  Pose T_map_sensor = Pose::Identity();
  Vector6d velocity = Vector6d::Zero();  // of the walk, sensor axes (turn rad/s, shift m/s)
  double since_s = 0;
};

struct Relocalisation {
  Registration found;  // rigid; overlap 0 when nothing was found
  // Of the places other than `found`, the strongest evidence against it: the number of points that agree with the map
  // there and not at `found`, divided by the number for which the reverse is true, times how much more likely the walk
  // is to have led there. Points that agree at both places, mostly ground, tell nothing (McNemar 1947). About 1: the
  // right place cannot be told.
  double doubt = 0;
};

// Tries all places and headings that a walking person can have reached (map z is taken as up). Each is scored by the
// likelihood of the points under the distributions of the middle level of the map (Biber and Strasser 2003), and the
// best separate ones are registered. Throws Error{cancelled}.
Relocalisation relocalise(const FeatureSet& features, const FeatureMaps& maps, const LastSeen& last, double span_s,
                          const RegistrationSettings& settings, const Run& run);

}  // namespace bole::slam
