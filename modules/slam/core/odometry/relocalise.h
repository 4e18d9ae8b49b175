// Finding the sensor again in the map after a gap in the recording or after frames that did not fit.
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
  // Of the places that are other ones than `found`, the one that speaks most against it: points that agree with the map
  // there and not at `found`, over those of which the reverse is true. Points that agree at both, most of the ground,
  // tell nothing (McNemar 1947). Times how much likelier the walk is to have led there. About 1: it cannot be told
  // which place is right.
  double doubt = 0;
};

// Tries all places and headings that a walking person can have reached (map z taken as up): each is scored by how
// likely the points are under the distributions of the map's middle level (Biber and Strasser 2003), the best apart
// from each other are registered. Throws Error{cancelled}.
Relocalisation relocalise(const FeatureSet& features, const FeatureMaps& maps, const LastSeen& last, double span_s,
                          const RegistrationSettings& settings, const Run& run);

}  // namespace bole::slam
