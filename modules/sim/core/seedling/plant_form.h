// The form of a seedling as curves and leaves, before it becomes triangles.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/core/seedling/seedling_recipe.h"

namespace bole::sim {

// A stem or a branch.
struct PlantAxis {
  std::vector<Eigen::Vector3d> points;  // about 2 mm apart, from the base to the tip
  std::vector<double> arc;              // metres along the axis
  std::vector<double> radii;            // metres
  int parent = -1;                      // -1: the stem
  double parent_arc = 0;                // where it leaves its parent

  Eigen::Vector3d point_at(double at_arc) const;
  Eigen::Vector3d tangent_at(double at_arc) const;
  double radius_at(double at_arc) const;
  double length() const { return arc.back(); }
};

// One leaf: petiole with wings, and a blade. `frame`: columns along the petiole, across, and up (out of the upper
// side).
struct PlantLeaf {
  int axis = 0;
  double axis_arc = 0;
  Eigen::Vector3d base;
  Eigen::Matrix3d frame;
  double petiole = 0, petiole_radius = 0, wing = 0;          // metres; wing: width of both wings
  double length = 0, width = 0, thickness = 0;               // of the blade, metres
  double droop = 0, fold = 0, cup = 0, wave = 0, phase = 0;  // droop and fold in radians; cup and wave / half width
  double yellow = 0, hue = 0, brightness = 1;                // looks
};

struct PlantForm {
  Eigen::Vector3d foot;         // middle of the stem at the soil
  std::vector<PlantAxis> axes;  // the stem first
  std::vector<PlantLeaf> leaves;
};

// Axes z up, metres. The same seed grows the same plant.
PlantForm grow_seedling(const SeedlingRecipe& recipe, std::uint64_t seed, const Eigen::Vector3d& foot);

// Half of a blade's width at a share 0 to 1 of its length, in half widths.
double blade_outline(double along);

// A point of the middle surface of a blade that begins at `base` and has the form of `leaf`; along 0 to 1, across -1
// to 1.
Eigen::Vector3d blade_point(const PlantLeaf& leaf, double along, double across);
// The same of the wings of the petiole.
Eigen::Vector3d wing_point(const PlantLeaf& leaf, double along, double across);

}  // namespace bole::sim
