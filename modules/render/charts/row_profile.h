// One row of plants: the row from the side with its plants and gaps, and how far its plants stand apart.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "render/charts/linked_charts.h"
#include "render/draw/axes.h"

namespace bole::render {

struct RowPlant {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // world coordinates, metres
  double along_m = 0;                            // of the row, from its beginning
  int number = 0;                                // in its row
  std::int64_t tree_id = 0;                      // 0: not known
  bool missing = false;
};

// A place along a line of corners: metres from its beginning and off it, to the left positive.
Eigen::Vector2d along_and_off(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& at);

// Of the table of plants that the stages of rows write, by place along the row. `course`: two corners at least.
std::vector<RowPlant> plants_of_row(const Table& plants, const std::string& row_id,
                                    const std::vector<Eigen::Vector2d>& course);

struct RowProfileData {
  std::vector<Eigen::Vector2d> points;  // metres along the row and above ground
  std::vector<RowPlant> plants;
  double length_m = 1, top_m = 3;
  std::int64_t selected = 0;
};

Frame row_frame(const RowProfileData& data, double width_mm, double height_mm);
// Plants have their number, gaps a square.
Figure row_profile(const RowProfileData& data, double width_mm, double height_mm);

// A bar from each plant to the next that is there, as high as they stand apart; amber where plants are missing between,
// with the median of the others.
LinkedChart plant_distances(const std::vector<RowPlant>& plants, const ChartSize& size, SelectedTree selected);

}  // namespace bole::render
