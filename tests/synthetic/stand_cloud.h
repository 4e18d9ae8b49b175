// A small stand as a point cloud, with the ground: for what is seen of a cloud before anything is measured in it.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>

#include "cloud/point_cloud.h"

namespace bole::synthetic {

struct StandOptions {
  int stems = 16;  // on a grid 3 m wide
  double diameter = 0.25, height = 15;
  int points_per_metre = 400;  // of a stem
  double ground_points_per_m2 = 200;
  double slope = 0.1;   // dz/dx
  double relief = 0.3;  // amplitude of the undulation, metres
  double noise = 0.01;
  double base_z = 100;
  unsigned seed = 1;
};

inline PointCloud::Positions stand_points(const StandOptions& o) {
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<double> u(0, 1);
  std::normal_distribution<double> normal;
  const int side = static_cast<int>(std::ceil(std::sqrt(o.stems)));
  constexpr double spacing = 3;
  const double width = spacing * std::max(1, side);
  const auto ground = [&](double x, double y) {
    return o.base_z + o.slope * x + o.relief * std::sin(0.5 * x) * std::cos(0.4 * y);
  };
  PointCloud::Positions out;
  for (int i = 0; i < static_cast<int>(width * width * o.ground_points_per_m2); ++i) {
    const double x = width * u(random), y = width * u(random);
    out.emplace_back(Eigen::Vector3d(x, y, ground(x, y) + o.noise * normal(random)).cast<float>());
  }
  for (int s = 0; s < o.stems; ++s) {
    const double x = spacing * (s % side + 0.3 + 0.4 * u(random)), y = spacing * (s / side + 0.3 + 0.4 * u(random));
    for (int i = 0; i < static_cast<int>(o.height * o.points_per_metre); ++i) {
      const double h = o.height * u(random), bearing = 2 * std::numbers::pi * u(random);
      const double r = 0.5 * o.diameter * (1.05 - 0.04 * h) + o.noise * normal(random);
      out.emplace_back(
          Eigen::Vector3d(x + r * std::cos(bearing), y + r * std::sin(bearing), ground(x, y) + h).cast<float>());
    }
  }
  return out;
}

inline PointCloud stand_cloud(const StandOptions& o = {}) { return PointCloud(stand_points(o)); }

// The points of a cloud under a linear map.
inline PointCloud mapped(const PointCloud& cloud, const Eigen::Matrix3d& matrix) {
  auto points = cloud.positions();
  for (auto& p : points) p = (matrix * p.cast<double>()).cast<float>();
  return PointCloud(std::move(points));
}

}  // namespace bole::synthetic
