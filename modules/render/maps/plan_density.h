// What a cloud looks like from above.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

// How many points lie over each cell of a plan.
struct PlanDensity {
  double cell_m = 0.05;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  // of the cell (0, 0), x east, y north
  int width = 0, height = 0;
  std::vector<float> points;  // row by row from the south

  void add(const Eigen::Vector2d& at);
  Eigen::Vector2d opposite() const { return corner + cell_m * Eigen::Vector2d(width, height); }
};
// Cells of `cell_m`, or larger where one side would have more than 2000.
PlanDensity plan_density(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell_m);

// The plan in grey, north up: white where there is no point, darkest (`darkest`, of 255) where the densest hundredth of
// the cells is. Logarithmic.
Image density_image(const PlanDensity& plan, double darkest = 125);

}  // namespace bole::render
