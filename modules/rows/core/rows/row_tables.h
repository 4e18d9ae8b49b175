// Rows as tables.
#pragma once

#include <string>

#include "rows/core/rows/find_rows.h"
#include "rows/core/rows/row_blocks.h"

namespace bole::rows {

// Everything that the tables are made of. `order` are indices of `rows`, as they are to be listed.
struct RowSet {
  const Table* stems = nullptr;
  std::vector<std::size_t> stem_rows;  // row of `stems` per plant
  Points2 plants;                      // less `origin`
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  std::vector<PlantRow> rows;
  std::vector<std::string> labels;  // row_id per row, when the stems bring one; else numbers in the order of the list
  bool labels_are_numbers = true;
  std::vector<RowBlock> blocks;
  std::vector<int> order;
  std::vector<int> strays;  // plants
};

void fill_tables(const RowSet& set, FoundRows& found);

}  // namespace bole::rows
