// The print of a ChArUco board, for scenes. Its markers come from OpenCV's dictionaries.
#pragma once

#include <cmath>
#include <memory>
#include <opencv2/aruco.hpp>
#include <vector>

#include "cloud/core/view_source.h"

namespace bole::synthetic {

// 9 x 7 squares of 3 cm.
inline BoardFacts small_board() {
  BoardFacts facts;
  facts.columns = 9;
  facts.rows = 7;
  facts.square = 0.03;
  facts.marker = 0.022;
  return facts;
}

// Brightness (0 black, 1 white) of a place of the board, below zero outside of it. x to the right and y up on the
// print; (0, 0) is its lower left corner. The markers are counted from the upper row, or from the lower one.
inline std::function<double(double, double)> board_print(const BoardFacts& facts, const Eigen::Vector2d& corner,
                                                         bool from_upper_row = true) {
  constexpr int bits = 4, cells = bits + 2;
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  auto markers = std::make_shared<std::vector<cv::Mat>>();
  for (int id = 0; id < 50; ++id) {
    cv::Mat image;
    cv::aruco::drawMarker(dictionary, id, cells, image, 1);
    markers->push_back(image);
  }
  return [=](double wx, double wy) {
    const double x = wx - corner.x(), y = wy - corner.y();
    const int column = static_cast<int>(std::floor(x / facts.square));
    const int row = static_cast<int>(std::floor(y / facts.square));
    if (column < 0 || row < 0 || column >= facts.columns || row >= facts.rows) return -1.0;
    const int from_first = from_upper_row ? facts.rows - 1 - row : row;
    const auto black = [&](int c, int r) { return ((c + r) % 2 == 0) == facts.first_square_black; };
    if (black(column, from_first)) return 0.0;
    int id = 0;
    for (int r = 0; r <= from_first; ++r)
      for (int c = 0; c < facts.columns; ++c)
        if (!black(c, r) && (r < from_first || c < column)) ++id;
    const double u = x - (column + 0.5) * facts.square + facts.marker / 2;
    const double v = (row + 0.5) * facts.square - y + facts.marker / 2;
    if (u < 0 || v < 0 || u >= facts.marker || v >= facts.marker) return 1.0;
    const int cu = static_cast<int>(u / facts.marker * cells), cv = static_cast<int>(v / facts.marker * cells);
    return (*markers)[static_cast<std::size_t>(id)].at<std::uint8_t>(cv, cu) > 0 ? 1.0 : 0.0;
  };
}

}  // namespace bole::synthetic
