// Which of its four prints a ChArUco board is, by the markers that are seen.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "cloud/core/view_source.h"

namespace bole::rgbd {

// Where the print begins: colour of its first square, and whether the markers are counted from the upper or the lower
// row. Versions of OpenCV differ in both.
struct BoardLayout {
  bool first_square_black = true;
  bool from_upper_row = true;
  bool operator==(const BoardLayout&) const = default;
};
std::string describe(const BoardLayout& layout);

// A square by its column from the left and its row from below.
struct BoardSquare {
  int column = 0, row = 0;
};

// The squares that carry markers, by the number of the marker.
std::map<int, BoardSquare> squares_of(const BoardFacts& facts, const BoardLayout& layout);

// Corners clockwise as they are seen, from the upper left.
struct BoardMarker {
  int id = 0;
  std::array<Eigen::Vector2d, 4> pixels, plane;  // in the image; on the plane z = 1 of the camera
};

// Each marker says where its neighbours lie, by its own edges: a lens that is not known yet does not disturb that. With
// an odd number of columns two prints differ only at the ends of their rows, so where these are hidden nothing can be
// told, and the stated colour of the first square holds; another needs two pairs of neighbours more.
BoardLayout layout_of_markers(const BoardFacts& facts, const std::vector<BoardMarker>& markers);

}  // namespace bole::rgbd
