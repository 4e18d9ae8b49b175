// The ways of the sensors of several runs on the cloud of one.
#pragma once

#include <string>
#include <vector>

#include "cloud/trajectory.h"
#include "render/draw/figure.h"
#include "render/maps/plan_density.h"

namespace bole::render {

struct ComparedPath {
  std::string name;
  Color color;
  Trajectory path;  // in the axes of the plan
};

// Where two paths are furthest apart at equal times.
struct FurthestApart {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // between the two
  double distance_m = 0;                            // in the plan; 0: they have no time in common
};
FurthestApart furthest_apart(const Trajectory& a, const Trajectory& b);

// The paths over the cloud in grey, and beside it the place where the first two are furthest apart.
// Throws Error{bad_input} without paths.
Figure paths_on_cloud(const std::vector<ComparedPath>& paths, const PlanDensity& cloud, double width_mm);

}  // namespace bole::render
