// The diameter of a measured stem at any height, from the points of a thin cut and what its joint fit tells about it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cloud/table.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {

// A point of a cut: in the plan from where the axis is expected at the height of the cut, and by how much it lies above
// that height; metres.
struct CutPoint {
  Eigen::Vector2d plan = Eigen::Vector2d::Zero();
  double above_m = 0;
  int pass = 0;
};

// Points of horizontal cuts in a plane across an axis of a slope, metres in plan per metre of height, and back. A
// horizontal cut shows a leaning stem too long along its lean.
class AcrossAxis {
 public:
  explicit AcrossAxis(const Eigen::Vector2d& slope);
  Eigen::Vector2d across(const CutPoint& p) const;
  Eigen::Vector2d plan(const Eigen::Vector2d& across) const;

 private:
  Eigen::Vector2d slope_, along_;
  double cosine_;
};

struct StemCut {
  double above_breast_m = 0;  // its middle, along the vertical
  std::vector<CutPoint> points;
};

// What is known of a stem that helps to judge a circle of it elsewhere. Metres.
struct KnownStem {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  // of the axis, metres in the plan per metre of height
  double radius_m = 0, taper = 0;                   // at breast height; of radius per metre of height, upwards less
  double radius_half_m = 0;  // half the 95 % interval of the radius at breast height; NaN where not known
  double arc_rad = 0;        // seen at breast height
  double too_wide_m = 0;     // by how much radii of plain circles exceed those of the joint fit
  double too_wide_sd_m = 0;  // standard deviation of that middle value
  double cut_sd_m = 0;       // of plain circles of single cuts about the joint fit; 0 where fewer than three are known
};

// Of row `row` of a stem table. Columns that are absent leave their values as above.
KnownStem known_stem(const Table& stems, std::size_t row);

// Where cuts that compare_cuts() learns from lie, metres above breast height.
inline constexpr std::array<double, 7> rises_near_breast_height_m{-0.45, -0.3, -0.15, 0, 0.15, 0.3, 0.45};

// Learns from cuts near breast height, where the joint fit holds, how plain circles of these points differ from it.
// Nothing where radius_half_m is NaN: a diameter that a person gave is no fit to correct circles by.
void compare_cuts(const std::vector<StemCut>& near_breast_height, KnownStem& known);

struct DiameterAtHeight {
  Circle circle;  // centre in the axes of the points; radius across the axis, what plain circles exceed taken off
  double radius_low = 0, radius_high = 0;  // 95 % interval; NaN where breast height has none
  double sigma = 0;                        // scatter of the points about the circle, metres
  double arc_rad = 0;                      // part of the circle with points at this height
  int inliers = 0;
};

// Nothing where the points hold no circle of a stem near `expected_radius_m`, or show less than 80 degrees of one.
std::optional<DiameterAtHeight> diameter_at_height(const std::vector<CutPoint>& points, double expected_radius_m,
                                                   const KnownStem& known);

}  // namespace bole::stems
