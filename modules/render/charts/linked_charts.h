// Charts whose points and bars are trees: a window marks the selected tree in them, and a click selects one.
#pragma once

#include <cstdint>
#include <optional>

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct ChartMark {
  std::vector<std::int64_t> trees;  // one for a point, those of the class for a bar
  Box box;                          // on the sheet, millimetres; of no extent for a point
};

struct LinkedChart {
  Figure figure;
  std::vector<ChartMark> marks;

  // The tree of the mark within `reach_mm` of a place. In a bar with several trees, the one after `selected`.
  std::optional<std::int64_t> tree_at(const Eigen::Vector2d& mm, double reach_mm,
                                      std::optional<std::int64_t> selected) const;
};

struct ChartSize {
  double width_mm = 90, height_mm = 65;
};

// Stems per class of DBH, from the stem table.
LinkedChart diameter_histogram(const Table& stems, const ChartSize& size, std::optional<std::int64_t> selected);

// Height over diameter, in the colours of quality; heights that were not seen to the top are rings.
LinkedChart height_over_diameter(const Table& stems, const ChartSize& size, std::optional<std::int64_t> selected);

// Estimated over field diameter of matched trees, with the 1:1 line.
LinkedChart estimated_over_field(const Table& matches, const ChartSize& size, std::optional<std::int64_t> selected);

}  // namespace bole::render
