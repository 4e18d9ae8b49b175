// What loop closures do to a path and to its map: runs of one recording below each other (figure 4 of the paper on
// orchard mapping, SPEC D, with the whole path beside the zoom of the map).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cloud/trajectory.h"
#include "render/draw/figure.h"
#include "render/maps/plan_density.h"

namespace bole::render {

struct LoopRun {
  std::string name;
  std::string note;  // beside the name: "12 loop closures, ATE 3.1 cm"
  Color color;
  Trajectory path;                               // in the axes of the sheet
  std::vector<std::pair<double, double>> loops;  // times of the two places that each closure joins, seconds
  PlanDensity map;                               // of the window, in the axes of the sheet; empty: no cloud
};

// The square that the maps show.
struct MapWindow {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double reach_m = 3;  // half a side
  Eigen::Vector2d lo() const { return centre.array() - reach_m; }
  Eigen::Vector2d hi() const { return centre.array() + reach_m; }
};

// The place where the paths of the first two runs are furthest apart, so wide that it shows what stands around it.
MapWindow loop_window(const Trajectory& first, const Trajectory& second);

// A row of two panels per run: its path from above over the reference (may be empty) with lines that join the places of
// each loop closure, and its map in the window. Throws Error{bad_input} without runs.
Figure loop_sheet(const std::vector<LoopRun>& runs, const Trajectory& reference, const MapWindow& window,
                  double width_mm);

}  // namespace bole::render
