// A cloud in a box with axes, seen from the side and a little from above: parallel projection, drawn as vectors.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/draw/axes.h"

namespace bole::render {

// A point to draw, metres.
struct ViewedPoint {
  Eigen::Vector3d at;
  Color color;
};

class ObliqueView {
 public:
  // The box from `lo` to `hi` (metres; x right, y ahead, z up), as large as fits into `sheet` (millimetres) with its
  // numbers and labels around it.
  ObliqueView(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, const Box& sheet);

  Eigen::Vector2d map(const Eigen::Vector3d& p) const;

  // Floor with grid, the edges of the box, numbers and labels in metres.
  void draw_axes(Canvas& canvas) const;
  // Far points first, so that near ones cover them.
  void draw_points(Canvas& canvas, std::vector<ViewedPoint> points, double diameter_mm) const;

 private:
  Eigen::Vector2d flat(const Eigen::Vector3d& p) const;  // on the picture plane, metres, up positive
  double depth(const Eigen::Vector3d& p) const;
  Eigen::Vector3d lo_, hi_;
  double mm_per_m_ = 1;
  Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();
};

}  // namespace bole::render
