// The pot: a body of revolution about the vertical, and the soil inside of it.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/run.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

// A cone about the vertical through `centre`, in points whose z is up.
struct FoundPot {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double foot_height = 0, rim_height = 0;  // z
  double foot_radius = 0, rim_radius = 0;
  double lip = 0;       // how far the rim stands out beyond the cone
  double sigma = 0;     // scatter of the wall's points about the cone
  double coverage = 0;  // share of the directions around it that are seen

  double radius_at(double z) const;
};

struct PotSearch {
  double bottom = 0, top = 0;  // z between which the wall is looked for
  double min_radius = 0, max_radius = 0;
  double tolerance = 0;  // of the wall
  double slice = 0;      // thickness of the layers that circles are fitted to
};

// Circles in thin layers that agree on centre and on a radius that changes evenly with height. Nothing where fewer than
// three layers above one another do.
std::optional<FoundPot> find_pot(const Points3& level, const PotSearch& search, const Run& run);

// The surface of the soil: z = height + slope . (p - centre) + curvature |p - centre|^2.
struct FoundSoil {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double height = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double curvature = 0;
  double sigma = 0;  // scatter of the cells about it
  double cell = 0;   // edge of a cell
  std::size_t cells = 0;

  double at(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d d = place - centre;
    return height + slope.dot(d) + curvature * d.squaredNorm();
  }
  Eigen::Vector2d slope_at(const Eigen::Vector2d& place) const { return slope + 2 * curvature * (place - centre); }
};

// The soil among the points within `radius` of `centre` between two heights: the lowest points of small cells in plan,
// and through them a plane or, where it is clearly better, a paraboloid, by Tukey's weights. Nothing where too few
// cells agree.
std::optional<FoundSoil> find_soil(const Points3& level, const Eigen::Vector2d& centre, double radius, double bottom,
                                   double top, double tolerance);

}  // namespace bole::plant
