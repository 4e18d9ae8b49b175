// What lies over a 3-D view on the screen: legend, scale bar, north arrow, what was picked and measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/draw/cloud_key.h"
#include "render/draw/figure.h"
#include "render/scene/point_paint.h"
#include "render/scene/tree_marks.h"

namespace bole::render {

// Millimetres from the upper left corner of the view.
struct ViewFurniture {
  double width_mm = 0, height_mm = 0;
  std::optional<PointPaint> paint;         // legend; none without points
  double mm_per_metre = 0;                 // at the middle of the view; 0: no scale bar
  bool perspective = true;                 // said beside the bar: it holds at the middle only
  double grid_step_m = 0;                  // said beside the bar; 0: no grid
  double contour_step_m = 0;               // said there too; 0: no contour lines
  bool north = true;                       // an arrow, where y points north
  double north_rad = 0;                    // where north points on the screen, counter-clockwise from up
  std::vector<std::string> notes;          // lines in the upper left corner
  std::vector<CloudKey> clouds;            // beside the survey; below the north arrow
  std::optional<PointPaint> clouds_paint;  // legend of one of them; left of that of the survey

  struct Label {
    Eigen::Vector2d at_mm;
    std::string text;
    bool strong = false;
  };
  struct Line {
    std::vector<Eigen::Vector2d> points_mm;
    bool strong = false, warning = false;
  };
  std::vector<TreeMark> trees;            // kept apart already
  bool tree_legend = false;               // what their symbols mean
  std::vector<Eigen::Vector2d> marks_mm;  // picked points
  std::vector<Label> labels;              // of measurements
  std::vector<Line> lines;                // the measurements themselves; drawn by the layer, not in patches
};

// A small picture to lie over the view, so that only what changed is drawn anew while the camera moves.
struct FurniturePatch {
  std::string state;  // patches of equal state look alike, wherever they lie
  Box box;            // on the view
  Figure figure;      // of the size of the box (figure_overlay)
};
std::vector<FurniturePatch> furniture_patches(const ViewFurniture& furniture);

}  // namespace bole::render
