// The boundary that counts: a rectangle or circle on the ground.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace bole {

// In the axes of the stems, sides along x and y; all metres and horizontal.
struct PlotArea {
  enum class Shape { none, rectangle, circle };
  Shape shape = Shape::none;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double width_m = 0;   // along x; the diameter of a circle
  double height_m = 0;  // along y; unused for a circle

  double area_m2() const {
    switch (shape) {
      case Shape::rectangle:
        return width_m * height_m;
      case Shape::circle:
        return std::numbers::pi / 4 * width_m * width_m;
      default:
        return std::nan("");
    }
  }

  // The boundary counts as inside. Without a boundary everything is.
  bool contains(double x, double y) const {
    const double dx = x - centre.x(), dy = y - centre.y();
    switch (shape) {
      case Shape::rectangle:
        return std::abs(dx) <= width_m / 2 && std::abs(dy) <= height_m / 2;
      case Shape::circle:
        return dx * dx + dy * dy <= width_m * width_m / 4;
      default:
        return true;
    }
  }

  // A closed outline without its last point twice; empty without a boundary.
  std::vector<Eigen::Vector2d> outline() const {
    std::vector<Eigen::Vector2d> points;
    if (shape == Shape::rectangle)
      for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        points.emplace_back(centre.x() + sx * width_m / 2, centre.y() + sy * height_m / 2);
    if (shape == Shape::circle)
      for (int i = 0; i < 180; ++i)
        points.emplace_back(
            centre +
            width_m / 2 * Eigen::Vector2d(std::cos(i * std::numbers::pi / 90), std::sin(i * std::numbers::pi / 90)));
    return points;
  }
};

}  // namespace bole
