// Plants and the lines of their rows in the plan: what the figures of rows have in common.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "render/maps/map_frame.h"

namespace bole::render {

struct PlannedRow {
  std::string id;
  std::vector<Eigen::Vector2d> vertices;
};

// The vertices of a table row_id, x_m, y_m, those of a row one after the other.
std::vector<PlannedRow> planned_rows(const Table& lines);
// x_m, y_m; those whose `state` is missing, where there is such a column, are left out.
std::vector<Eigen::Vector2d> standing_plants(const Table& plants);

struct RowLook {
  Color color;
  bool dashed = false;
  double width_mm = 0.35;
  bool ids = true;  // beside the first end of each line
};
void draw_planned_rows(Canvas& canvas, const Frame& frame, const std::vector<PlannedRow>& rows, const RowLook& look);

// All plants and vertices with space around them for the ids.
MapExtent extent_of_rows(const std::vector<PlannedRow>& rows, const std::vector<Eigen::Vector2d>& plants);

// "East (m)" and "North (m)" where north is known, else "x (m)" and "y (m)".
AxesStyle row_axes(bool north_known);

// A bold letter and a title at the upper left corner of a panel; returns the space that it takes, millimetres.
double draw_panel_title(Canvas& canvas, const Eigen::Vector2d& corner, const std::string& letter,
                        const std::string& title);

}  // namespace bole::render
