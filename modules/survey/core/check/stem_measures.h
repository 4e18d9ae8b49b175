// How sharp the cloud is at each stem of a table.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <vector>

#include "survey/core/check/check_grid.h"

namespace bole::survey {

struct StemMeasure {
  std::size_t row = 0;  // of the table
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double dbh_cm = 0;              // NaN where it is not known
  std::size_t points = 0;         // on its bark, 0.9 to 1.7 m above the ground
  double wall_cm = 0;             // scatter of these points about the bark; NaN with fewer than 30
  double pass_spread_cm = 0;      // greatest distance between the axes of two passes; NaN with fewer than two
  std::set<std::int32_t> passes;  // that show it
};

// Of the kept stems of the table in the grid.
std::vector<StemMeasure> measure_stems(const CheckInputs& inputs, const CheckGrid& grid,
                                       const std::vector<float>& heights, const std::vector<std::int32_t>& passes,
                                       const Run& run);

struct MissedStem {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double dbh_cm = 0;
};

// Upright round structures of at least `min_dbh_cm` through breast height that no stem of the table explains (cloud
// with heights needed).
std::vector<MissedStem> missed_stems(const CheckInputs& inputs, const CheckGrid& grid,
                                     const std::vector<float>& heights, double min_dbh_cm, const Run& run);

}  // namespace bole::survey
