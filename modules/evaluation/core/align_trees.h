// Two maps of the same trees brought together.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace bole::evaluation {

// A tree as far as the search needs it; a diameter that is not known is NaN.
struct MapTree {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double dbh_cm = 0;
};

// The rotation (in steps of half a degree, all directions) and shift that bring most trees of `from` within about
// 0.5 m of trees of `to` with diameters that differ by no more than `dbh_gate_cm` (0: any). Every pair votes for a
// shift; the fullest cell wins, of equals the smaller turn. Of many trees the thickest 200 take part. The result is
// right to some decimetres: a start for a least-squares fit. Identity when either list is empty.
Eigen::Isometry2d likeliest_motion(std::vector<MapTree> from, std::vector<MapTree> to, double dbh_gate_cm);

}  // namespace bole::evaluation
