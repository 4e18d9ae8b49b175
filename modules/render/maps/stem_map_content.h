// What a stem map shows, as plain positions: for the figure and for the plan on the page of a report.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "render/draw/axes.h"
#include "render/draw/color.h"
#include "render/maps/stem_map.h"

namespace bole::render {

struct MapStem {
  Eigen::Vector2d at;
  double dbh_m = 0;
  std::string id;
  std::string quality;
  Color color;  // of its quality
  bool is_false = false;
};

struct MapMark {
  Eigen::Vector2d at;
  std::string name;
};

struct StemMapContent {
  std::vector<MapStem> stems;
  std::vector<MapMark> missed, targets;
  std::vector<Eigen::Vector2d> path, outline;
  bool compared = false, north_known = true;
};

// Stems without a position are left out; one without a diameter is drawn with 10 cm.
StemMapContent stem_map_content(const StemMapData& data);

// The part of the plan that is shown (the boundary with a margin, else the stems) in a box of this width whose left
// upper corner is at `corner`.
Frame stem_map_frame(const StemMapContent& content, const Eigen::Vector2d& corner, double width_mm);

}  // namespace bole::render
