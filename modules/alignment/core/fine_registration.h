// A cloud that lies roughly right is moved until it fits another one.
#pragma once

#include <Eigen/Core>

#include "alignment/core/similarity.h"
#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::alignment {

struct FineOptions {
  double reach_m = 0.5;  // how far apart the same place in both clouds may be at the start
};

// Why a cloud was left where it was.
enum class FineEnd {
  converged,
  apart,      // too few of its points have a partner within the reach
  restless,   // the steps do not come to an end
  open,       // it could slide or turn along `open_shift`, `open_turn` and fit as well
  no_better,  // it fitted as well at the start
};

struct FineRegistration {
  FineEnd end = FineEnd::apart;
  bool converged() const { return end == FineEnd::converged; }
  Similarity motion;  // of the cloud as it was given, at scale 1; the identity unless converged

  // Where it came to rest, and where it began. RMS: of the distances of the paired points from the planes of the other
  // cloud; overlap: share of the points with a partner. Both within `final_reach_m`.
  double rms_m = 0, start_rms_m = 0;
  double overlap = 0, start_overlap = 0;
  double final_reach_m = 0;
  std::size_t points = 0, pairs = 0;  // of the thinned cloud that was moved
  int steps = 0;

  // Of FineEnd::open: unit shift and turn axis of the motion that the points leave open, each scaled by its share.
  Eigen::Vector3d open_shift = Eigen::Vector3d::Zero(), open_turn = Eigen::Vector3d::Zero();
};

// Iterative closest points to planes, see README.md. `moved` as it is placed, in the axes of `fixed`. Throws
// Error{bad_input} for an empty cloud and a reach that is not above zero, Error{cancelled}.
FineRegistration register_finely(const PointCloud& moved, const PointCloud& fixed, const FineOptions& options,
                                 const Run& run);

}  // namespace bole::alignment
