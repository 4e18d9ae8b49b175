// Charts whose points and bars are trees: a window marks the selected tree in them, and a click selects one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

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

struct RowPlant;

// What charts are drawn from. Null: the run has no such table.
struct ChartTables {
  const Table* stems = nullptr;
  const Table* matches = nullptr;   // of stems with trees measured in the field
  std::span<const RowPlant> row{};  // of the selected row of plants
};

using SelectedTree = std::optional<std::int64_t>;

struct ChartType {
  std::string_view id, title;
  LinkedChart (*draw)(const ChartTables& tables, const ChartSize& size, SelectedTree selected);
};
// The charts of a stem map, in the order of a list; a new one is a line here. A missing table gives an empty chart.
std::span<const ChartType> linked_charts();

// Stems per class of DBH, from the stem table.
LinkedChart diameter_histogram(const Table& stems, const ChartSize& size, SelectedTree selected);

// Height over diameter, in the colours of quality; heights that were not seen to the top are rings.
LinkedChart height_over_diameter(const Table& stems, const ChartSize& size, SelectedTree selected);

// Estimated over field diameter of matched trees, with the 1:1 line.
LinkedChart estimated_over_field(const Table& matches, const ChartSize& size, SelectedTree selected);

}  // namespace bole::render
