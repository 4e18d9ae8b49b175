// A small plot as points on surfaces: a floor that is not level everywhere, and stems that lean a little.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/random.h"
#include "base/transform.h"
#include "cloud/point_cloud.h"

namespace bole::alignment {

struct StandShape {
  std::size_t floor = 40'000, of_stem = 2'000;  // points
  int stems = 12;
  double side_m = 16, noise_m = 0.01;
  double x_from_m = 0;  // only what lies beyond
};

// Other points of the same surfaces for another seed.
inline PointCloud small_stand(std::uint64_t seed, const StandShape& shape = {},
                              const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  Random random(seed, 0x57414e44);
  PointCloud::Positions points;
  const auto put = [&](Eigen::Vector3d p) {
    for (int k = 0; k < 3; ++k) p[k] += shape.noise_m * random.normal();
    if (p.x() >= shape.x_from_m) points.push_back(p.cast<float>());
  };
  const auto ground = [](double x, double y) { return 0.3 * std::sin(0.4 * x) + 0.2 * std::cos(0.5 * y); };
  for (std::size_t i = 0; i < shape.floor; ++i) {
    const double x = random.uniform(0, shape.side_m), y = random.uniform(0, shape.side_m);
    put({x, y, ground(x, y)});
  }
  Random places(7, 0x504c4143);  // the same stems for all
  for (int stem = 0; stem < shape.stems; ++stem) {
    const double x = places.uniform(1, shape.side_m - 1), y = places.uniform(1, shape.side_m - 1);
    const double radius = places.uniform(0.08, 0.2), lean = places.uniform(-0.03, 0.03);
    for (std::size_t i = 0; i < shape.of_stem; ++i) {
      const double h = random.uniform(0, 5), a = random.angle();
      put({x + lean * h + radius * std::cos(a), y + radius * std::sin(a), ground(x, y) + h});
    }
  }
  return PointCloud(std::move(points), origin);
}

// A cloud moved by T about a place.
inline PointCloud moved_cloud(const PointCloud& cloud, const Pose& T, const Eigen::Vector3d& about) {
  PointCloud out = cloud;
  PointCloud::Positions points;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points.push_back((about + T * (cloud.position(i) - about) - cloud.origin).cast<float>());
  out.set_positions(std::move(points));
  return out;
}

inline Pose pose_of(const Eigen::Vector3d& turn_deg, const Eigen::Vector3d& shift_m) {
  Pose T = Pose::Identity();
  T.linear() = so3_exp(turn_deg * 3.14159265358979 / 180).toRotationMatrix();
  T.translation() = shift_m;
  return T;
}

}  // namespace bole::alignment
