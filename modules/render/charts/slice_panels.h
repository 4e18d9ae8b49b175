// The points at breast height, tree by tree: for the slice sheet and for the page of a report.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::render {

struct SlicePoint {
  Eigen::Vector2f offset;  // from the stem's centre, metres
  int pass = 0;
};

struct SlicePanel {
  std::string id, quality, reasons;
  double dbh_m = 0, lo_m = 0, hi_m = 0;  // 0.2 m where the diameter is not known; NaN without an interval
  std::size_t found = 0;                 // points, of which some may not be drawn
  std::vector<SlicePoint> points;
};

// How far around its centre a panel looks.
double slice_reach_m(double dbh_m);

// One panel for each row of `stems`, with at most `max_points` points.
std::vector<SlicePanel> slice_panels(const Table& stems, const PointCloud& slice, int max_points);

}  // namespace bole::render
