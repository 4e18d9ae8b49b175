// Which trees of a survey count: a boundary on the ground and a least diameter.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole {
inline namespace cloud {

// In the axes of the stems; all metres are horizontal.
struct PlotArea {
  enum class Shape { none, rectangle, circle, polygon };
  Shape shape = Shape::none;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double width_m = 0;                     // of a rectangle across its bearing; the diameter of a circle
  double length_m = 0;                    // of a rectangle along its bearing
  double bearing_rad = 0;                 // from y (north) clockwise
  std::vector<Eigen::Vector2d> vertices;  // of a polygon, in order, the first not repeated

  double area_m2() const;  // NaN without a boundary

  // The boundary counts as inside. Without a boundary everything is.
  bool contains(const Eigen::Vector2d& point) const;
  bool contains(double x, double y) const { return contains(Eigen::Vector2d(x, y)); }

  // An outline without its last point twice, a circle by 180 points; empty without a boundary.
  std::vector<Eigen::Vector2d> outline() const;
};

PlotArea rectangle_area(const Eigen::Vector2d& centre, double width_m, double length_m, double bearing_rad = 0);
PlotArea circle_area(const Eigen::Vector2d& centre, double radius_m);
// Throws Error{bad_input} for fewer than three vertices, vertices that are no numbers, and an outline that crosses
// itself. The centre is that of its area.
PlotArea polygon_area(std::vector<Eigen::Vector2d> vertices);

// "32 m × 32 m", "circle of radius 15 m"; words for reports and messages.
std::string describe(const PlotArea& area);

// A tree counts when its centre at breast height lies inside and it is thick enough. Without a least diameter trees of
// unknown diameter (NaN) count too, so that no rule at all means every tree.
struct CountingRule {
  PlotArea area;
  double min_dbh_cm = 0;

  bool counts(const Eigen::Vector2d& position, double dbh_cm) const {
    return (min_dbh_cm <= 0 || dbh_cm >= min_dbh_cm) && area.contains(position);
  }
};

// A rule as a table travels between stages: rows are the outline (x_m, y_m), everything else is in the facts.
// The latter throws Error{bad_input} for a table that is none.
Table to_table(const CountingRule& rule);
CountingRule counting_rule(const Table& table);

}  // namespace cloud
}  // namespace bole
