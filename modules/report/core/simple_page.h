// A short HTML page of tables and pictures, for what is not a survey of a plot.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "report/core/picture.h"

namespace bole::report {

struct PageTable {
  std::string title, note;
  const Table* table = nullptr;
  std::vector<std::pair<std::string, std::string>>
      columns;  // column of the table, heading; absent columns are left out
  int decimals = 4;
};

struct SimplePage {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<PageTable> tables;
  std::vector<ReportPicture> pictures;
  std::vector<std::string> warnings;
};

// Needs nothing beside it. Numbers have `decimals` digits, missing ones a dash.
std::string simple_page_html(const SimplePage& page);

}  // namespace bole::report
