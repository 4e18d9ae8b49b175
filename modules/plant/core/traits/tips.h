// The outermost places of a plant, and where the pictures end them.
//
// A cloud loses the tips of leaves, which are thinner than its points lie apart, and noise puts others in their place.
// In a picture a tip is an edge: along the line that runs out of it the colour of the leaf becomes that of what is
// behind. Every view that sees the tip gives a place on that line; where they agree, the plant ends.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/run.h"
#include "cloud/core/view_source.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct Tip {
  Eigen::Vector3d place;     // in the cloud, plant axes
  Eigen::Vector3d outwards;  // unit: the way that the plant points there
  double move = 0;           // from `place` along `outwards` to the end of the plant in the pictures
  double sd = 0;             // of the move
  std::size_t seen = 0;      // views that show an edge on the line
  std::size_t agreed = 0;    // of those, the ones whose edges meet; 0: the tip was not measured
  bool measured() const { return agreed > 0; }
  Eigen::Vector3d end() const { return place + move * outwards; }
};

struct TipSearch {
  double reach = 0.008;      // of the neighbourhood that tells the way out, and of the line, in units of the cloud
  bool linear_light = true;  // sRGB undone: optics blur light, not codes
};

// The highest place, and the outermost ones in plan, each once.
std::vector<Tip> outermost_tips(const Points3& plant, double reach);

// Finds the ends of the tips in the pictures. `cloud`: everything around, for what hides a tip. `T_plant_world`: from
// the axes of the poses.
void measure_tips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world, const Points3& cloud,
                  double spacing, const TipSearch& search, const std::vector<std::uint32_t>& which,
                  std::vector<Tip>& tips, const Run& run);

// The points of the plant with measured tips where the pictures end them: what lies beyond is taken out.
Points3 with_tips(const Points3& plant, const std::vector<Tip>& tips, double reach);

}  // namespace bole::plant
