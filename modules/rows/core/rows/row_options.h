// Options of the search for rows.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/option.h"

namespace bole::rows {

// ordinary: least squares of y = a x + b; orthogonal: of the distances across the line.
enum class LineFitMethod { ordinary, orthogonal };
constexpr std::array<std::string_view, 2> choice_names(LineFitMethod) { return {"least_squares", "orthogonal"}; }

// as_found: rows that are clearly curved get a curve.
enum class RowShape { as_found, straight };
constexpr std::array<std::string_view, 2> choice_names(RowShape) { return {"auto", "straight"}; }

// What is left open is found from the plants.
struct RowOptions {
  LineFitMethod fit = LineFitMethod::ordinary;
  std::optional<double> plant_spacing;
  std::optional<double> row_spacing;
  std::optional<double> direction_deg;
  int max_gap = 6;
  int min_plants = 3;
  double lateral_tolerance = 0.4;
  RowShape shape = RowShape::as_found;
};

const OptionTable& option_table(const RowOptions*);

}  // namespace bole::rows
