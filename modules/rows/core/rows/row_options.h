// Options of the search for rows.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::rows {

struct RowOptions {
  std::string fit = "least_squares";
  double plant_spacing = 0;
  double row_spacing = 0;
  std::string direction = "auto";
  double direction_deg = 0;
  int gap_max = 6;
  int plants_min = 3;
  double lateral_tolerance = 0.4;
  std::string shape = "auto";
};

const OptionTable& option_table(const RowOptions*);

}  // namespace bole::rows
