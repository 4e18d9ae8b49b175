// What the report stage can be told.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::report {

struct ReportOptions {
  std::string title = "Forest plot survey";
  double figure_width = 180;
  double dpi = 300;
  int point_budget = 2'500'000;
  std::string backend = "auto";
  bool tables = true;
  bool cloud = true;
  bool figures = true;
  bool hero = false;
  bool vector_figures = true;
  bool page = true;
};

const OptionTable& option_table(const ReportOptions*);

}  // namespace bole::report
