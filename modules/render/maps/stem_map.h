// The stem map: every stem at its place and to scale.
#pragma once

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/draw/figure.h"

namespace bole::render {

struct StemMapData {
  const Table* stems = nullptr;  // tree_id, x_m, y_m, dbh_cm, quality
  PlotArea area;
  const Table* targets = nullptr;          // name, x_m, y_m
  const Trajectory* trajectory = nullptr;  // the walk
  const Table* matches = nullptr;          // of the evaluation: marks missed and false stems
  bool north_known = true;                 // plot or projected axes: y points north
};

// Copies what it draws: the data may go away afterwards. Its height follows from the extent of the plot.
Figure stem_map(const StemMapData& data, double width_mm);

}  // namespace bole::render
