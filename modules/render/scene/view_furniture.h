// What lies over a 3-D view on the screen: legend, scale bar, north arrow, what was picked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/draw/figure.h"
#include "render/scene/point_paint.h"

namespace bole {

struct ViewFurniture {
  double width_mm = 0, height_mm = 0;
  std::optional<PointPaint> paint;  // legend; none without points
  double mm_per_metre = 0;          // at the middle of the view; 0: no scale bar
  bool perspective = true;          // said beside the bar: it holds at the middle only
  double north_rad = 0;             // where north points on the screen, counter-clockwise from up
  bool north_known = true;
  std::vector<std::string> notes;          // lines in the upper left corner
  std::optional<Eigen::Vector2d> mark_mm;  // the picked point, from the upper left corner
};

// A figure to lie over the picture (figure_overlay).
Figure view_furniture(const ViewFurniture& furniture);

}  // namespace bole
