// The tables that a comparison of runs prints: parts of the table `groups` of evaluation.compare.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cloud/table.h"

namespace bole::report {

struct ComparePart {
  const char* file;
  const char* title;
  const char* note;
  // Column, heading on the page, digits there.
  struct Column {
    const char* name;
    const char* heading;
    int decimals;
  };
  std::vector<Column> columns;
};

// positions.csv (table 2 of the paper on improved LOAM), diameters.csv (table 3), detection.csv, trajectories.csv.
const std::vector<ComparePart>& compare_parts();

// The rows that have one of the numbers of a part, with the columns that say of what they are, those of the part, and
// published_NAME of each where there are such figures.
Table part_table(const ComparePart& part, const Table& measures);

// The same as words for a page: "0.012 (0.087)" with the published figure in brackets.
Table printed_part(const ComparePart& part, const Table& measures);

// Headings of the columns that printed_part() begins with, as far as `measures` fills them.
std::vector<std::pair<std::string, std::string>> page_columns(const ComparePart& part, const Table& printed);

}  // namespace bole::report
