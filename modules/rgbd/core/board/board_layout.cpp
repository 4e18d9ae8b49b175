#include "rgbd/core/board/board_layout.h"

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>

namespace bole::rgbd {
namespace {

constexpr int neighbourhood = 2;         // squares, in both directions
constexpr double max_off_squares = 0.5;  // a marker from where its neighbour says it is
constexpr int pairs_to_contradict = 2;

Eigen::Vector2d centre_of(const BoardMarker& m) { return (m.plane[0] + m.plane[1] + m.plane[2] + m.plane[3]) / 4; }

// From the plane of the image to squares of the board, near the marker; zero where its corners lie on one line.
Eigen::Matrix2d squares_per_plane(const BoardFacts& facts, const BoardMarker& m) {
  Eigen::Matrix2d edges;
  edges.col(0) = (m.plane[1] - m.plane[0] + m.plane[2] - m.plane[3]) / 2;
  edges.col(1) = (m.plane[0] - m.plane[3] + m.plane[1] - m.plane[2]) / 2;
  if (!(std::abs(edges.determinant()) > 0)) return Eigen::Matrix2d::Zero();
  return edges.inverse() * facts.marker / facts.square;
}

// Ordered pairs of neighbouring markers of which the first says rightly where the second is.
int pairs_that_agree(const BoardFacts& facts, const BoardLayout& layout, const std::vector<BoardMarker>& markers) {
  const auto squares = squares_of(facts, layout);
  int agree = 0;
  for (const auto& from : markers) {
    const auto at = squares.find(from.id);
    if (at == squares.end()) continue;
    const Eigen::Matrix2d to_squares = squares_per_plane(facts, from);
    for (const auto& to : markers) {
      const auto there = squares.find(to.id);
      if (&to == &from || there == squares.end()) continue;
      const Eigen::Vector2i step(there->second.column - at->second.column, there->second.row - at->second.row);
      if (step.cwiseAbs().maxCoeff() > neighbourhood) continue;
      const Eigen::Vector2d seen = to_squares * (centre_of(to) - centre_of(from));
      if ((seen - step.cast<double>()).norm() < max_off_squares) ++agree;
    }
  }
  return agree;
}

struct Counted {
  BoardLayout layout;
  int pairs = 0;
};

Counted from_either_row(const BoardFacts& facts, bool first_square_black, const std::vector<BoardMarker>& markers) {
  Counted best{{first_square_black, true}, 0};
  for (const bool upper : {true, false}) {
    const BoardLayout layout{first_square_black, upper};
    const int pairs = pairs_that_agree(facts, layout, markers);
    if (pairs > best.pairs) best = {layout, pairs};
  }
  return best;
}

}  // namespace

std::string describe(const BoardLayout& layout) {
  return std::string("first square ") + (layout.first_square_black ? "black" : "white") +
         ", markers counted from the " + (layout.from_upper_row ? "upper" : "lower") + " row";
}

std::map<int, BoardSquare> squares_of(const BoardFacts& facts, const BoardLayout& layout) {
  std::map<int, BoardSquare> out;
  int id = 0;
  for (int r = 0; r < facts.rows; ++r)
    for (int c = 0; c < facts.columns; ++c)
      if (((r + c) % 2 == 0) != layout.first_square_black)
        out[id++] = {c, layout.from_upper_row ? facts.rows - 1 - r : r};
  return out;
}

BoardLayout layout_of_markers(const BoardFacts& facts, const std::vector<BoardMarker>& markers) {
  const auto stated = from_either_row(facts, facts.first_square_black, markers);
  const auto other = from_either_row(facts, !facts.first_square_black, markers);
  return other.pairs >= stated.pairs + pairs_to_contradict ? other.layout : stated.layout;
}

}  // namespace bole::rgbd
