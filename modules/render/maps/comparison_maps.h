// Maps of several runs of one plot: where their stems are, and the ways of their sensors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/plot_area.h"
#include "cloud/trajectory.h"
#include "render/charts/match_group.h"
#include "render/draw/figure.h"

namespace bole::render {

// Reference positions as rings, those of each run as crosses (upright for the first, diagonal for the second). Errors
// are drawn `enlarge` times, 0: so that they can be seen; the caption says so. Missed trees are rings alone, extra ones
// crosses alone.
Figure position_map(const std::vector<MatchGroup>& runs, const PlotArea& area, double width_mm, double enlarge = 0);

// How many points lie over each cell of a plan: what a cloud looks like from above.
struct PlanDensity {
  double cell_m = 0.05;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  // of the cell (0, 0), x east, y north
  int width = 0, height = 0;
  std::vector<float> points;  // row by row from the south

  void add(const Eigen::Vector2d& at);
};
PlanDensity plan_density(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell_m);

struct ComparedPath {
  std::string name;
  Color color;
  Trajectory path;  // in the axes of the plan
};

// The paths over the cloud in grey, and beside it the place where the first two are furthest apart.
// Throws Error{bad_input} without paths.
Figure paths_on_cloud(const std::vector<ComparedPath>& paths, const PlanDensity& cloud, double width_mm);

}  // namespace bole::render
