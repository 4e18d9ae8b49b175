// Stems, branches and leaves of a plant, found in its points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "base/run.h"
#include "plant/core/leaves/axis_curve.h"
#include "plant/core/leaves/leaf_sheet.h"

namespace bole::plant {

constexpr double max_lost_share = 0.02;  // of the plant's points without connection with its stem

// All places are in plant axes: z up, the origin where the main stem leaves the soil.
struct PlantAxisFound {
  AxisCurve curve;  // of the main stem from the soil, of a branch from the middle of its parent
  int parent = -1;
  double parent_arc = 0;  // along the parent
  double angle = 0;       // to the parent, radians
};

struct Leaf {
  int axis = 0;
  double arc = 0;                                        // of its node along the axis
  Eigen::Vector3d node = Eigen::Vector3d::Zero();        // on the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // of the petiole, away from the axis
  double angle = 0;                                      // between petiole and axis, radians
  double petiole = 0;                                    // length from the surface of the axis to the blade
  LeafSheet sheet;
  bool on_other = false;      // its way to the stem leads over another leaf
  std::vector<int> touching;  // leaves that it shares a long border with
  std::string doubt;          // why to look at it; empty: good
};

struct PlantOrgans {
  std::vector<PlantAxisFound> axes;  // the main stem first; empty where no stem was found
  std::vector<Leaf> leaves;          // by axis, and along it
  std::vector<int> organ_of_point;   // -1: an axis or nothing, else the leaf
  std::size_t twigs = 0;             // organs without blade
  std::size_t gaps = 0;              // bridged
  double widest_gap = 0;
  bool sparse = false;    // the points lie too far apart for their neighbours to be known
  double lost_share = 0;  // of the points: not connected with the stem; above max_lost_share the plant is in pieces
  bool stem_ends_in_leaf = false;
};

struct OrganScales {
  double unit = 0.02;  // metres; lengths below are in it. Without a known scale: a share of the plant's height
  double spacing = 0, noise = 0;
  double max_gap = 0;
};

PlantOrgans find_organs(const Points3& plant, const OrganScales& scales, const Run& run);

}  // namespace bole::plant
