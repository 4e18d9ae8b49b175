// The measures of a check of the map, one small map each.
#pragma once

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/draw/figure.h"

namespace bole::render {

inline constexpr const char* check_maps_title = "The check of the map";

struct CheckMapsData {
  const Table* cells = nullptr;            // of survey.check: x_m, y_m and the measures; fact cell_m
  const Table* stems = nullptr;            // x_m, y_m, wall_cm, pass_spread_cm
  const Table* findings = nullptr;         // severity, x_m, y_m
  const Trajectory* trajectory = nullptr;  // the walk
  PlotArea area;
  bool north_known = true;
};

// Two maps beside each other, as many rows as there are measures with a value. Numbered rings are the findings with a
// place, in the order of their table. Copies what it draws. Throws Error{bad_input} without a cell.
Figure check_maps(const CheckMapsData& data, double width_mm);

}  // namespace bole::render
