// The printed mat: a ChArUco board of OpenCV (square 0 at the top left is black), on a sheet with a white margin.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace bole::sim {

// World axes: origin at the lower left corner of the pattern as it is printed upright, x to the right along a row of
// squares, y up the print, z out of it. OpenCV's rows count from the top: its y is height() - y.
class CharucoMat {
 public:
  CharucoMat();

  static constexpr int columns = 11, rows = 9;
  static constexpr double square = 0.030, marker = 0.022;  // metres
  static constexpr double margin = 0.010;                  // metres of white around the pattern
  static constexpr double width() { return columns * square; }
  static constexpr double height() { return rows * square; }

  // Share of black at a place, as the mean over a square of side `footprint` (metres). 0 outside of the pattern.
  double black(const Eigen::Vector2d& at, double footprint) const;

  // Inner corners of the chess pattern in OpenCV's order, in world axes.
  std::vector<Eigen::Vector3d> corners() const;

 private:
  bool black_at(double x, double y) const;  // y from the top
  // [marker][row][column] of 6 x 6 modules with the black border.
  std::vector<std::array<std::array<bool, 6>, 6>> bits_;
};

}  // namespace bole::sim
