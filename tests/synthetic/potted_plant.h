// A potted plant with known traits: points on its surfaces, and pictures of it with a known point spread.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/core/view_source.h"
#include "cloud/point_cloud.h"

namespace bole::tests {

// World axes: z up, the mat at z = 0, metres.
struct PottedPlant {
  Eigen::Vector3d foot{0.15, 0.12, 0.078};  // of the stem, on the soil
  double stem_length = 0.30;                // height of its tip above the soil
  double foot_diameter = 0.0062, taper = 0.006;
  Eigen::Vector2d lean{0.05, -0.03}, bow{0.3, 0.2};  // x = lean z + bow z^2
  double soil_slope = 0.02, soil_roughness = 0.0008;
  Eigen::Vector2d pot{0.152, 0.118};
  double rim_radius = 0.055, pot_foot_radius = 0.042, rim_height = 0.09;
  int leaves = 9;
  double leaf_length = 0.07, leaf_width = 0.03;

  Eigen::Vector3d axis(double z) const {  // z above the foot
    return foot + Eigen::Vector3d(lean.x() * z + bow.x() * z * z, lean.y() * z + bow.y() * z * z, z);
  }
  Eigen::Vector3d tangent(double z) const {
    return Eigen::Vector3d(lean.x() + 2 * bow.x() * z, lean.y() + 2 * bow.y() * z, 1).normalized();
  }
  double diameter(double z) const { return foot_diameter - taper * z; }
  double soil(double x, double y) const { return foot.z() + soil_slope * (x - foot.x()) + 0 * y; }

  // A leaf is a cambered sheet on a petiole: s along it in 0..1, t across in -1..1.
  Eigen::Vector3d leaf(int k, double s, double t) const {
    const double z = 0.09 + 0.2 * k / std::max(leaves - 1, 1), turn = 2.4 * k;
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0), side(-out.y(), out.x(), 0);
    const double petiole = 0.02, along = petiole + s * leaf_length;
    const double half = 0.5 * leaf_width * std::sqrt(std::max(0.0, 4 * s * (1 - s)));
    const double rise = 0.6 * along - 4.0 * along * along;
    return axis(z) + along * out + t * half * side + (rise + 0.15 * half * t * t) * Eigen::Vector3d::UnitZ();
  }
  Eigen::Vector3d petiole(int k, double s) const {
    const double z = 0.09 + 0.2 * k / std::max(leaves - 1, 1), turn = 2.4 * k, along = s * 0.02;
    return axis(z) + along * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0) +
           (0.6 * along - 4.0 * along * along) * Eigen::Vector3d::UnitZ();
  }

  // Points of everything but noise; `spacing` in metres.
  std::vector<Eigen::Vector3d> plant_points(double spacing, std::uint64_t seed = 1) const;
  std::vector<Eigen::Vector3d> scene_points(double spacing, std::uint64_t seed = 1) const;
};

inline std::vector<Eigen::Vector3d> PottedPlant::plant_points(double spacing, std::uint64_t seed) const {
  std::vector<Eigen::Vector3d> out;
  Random random(seed, 1);
  const double area = spacing * spacing;
  const int on_stem = static_cast<int>(std::numbers::pi * 0.005 * stem_length / area);
  for (int i = 0; i < on_stem; ++i) {
    const double z = random.uniform(0, stem_length), turn = random.angle(), r = diameter(z) / 2;
    const Eigen::Vector3d t = tangent(z), u = t.unitOrthogonal(), v = t.cross(u);
    out.push_back(axis(z) + r * (std::cos(turn) * u + std::sin(turn) * v));
  }
  for (int k = 0; k < leaves; ++k) {
    const int count = static_cast<int>(0.785 * leaf_length * leaf_width / area);
    for (int i = 0; i < count;) {
      const double s = random.uniform(), t = random.uniform(-1, 1);
      // Even by area: narrow places get fewer.
      if (random.uniform() > std::sqrt(std::max(0.0, 4 * s * (1 - s)))) continue;
      out.push_back(leaf(k, s, t));
      ++i;
    }
    for (int i = 0; i < static_cast<int>(0.02 * 0.006 / area); ++i) {
      const double turn = random.angle();
      out.push_back(petiole(k, random.uniform()) + 0.001 * Eigen::Vector3d(-std::sin(2.4 * k) * std::cos(turn),
                                                                           std::cos(2.4 * k) * std::cos(turn),
                                                                           std::sin(turn)));
    }
  }
  return out;
}

inline std::vector<Eigen::Vector3d> PottedPlant::scene_points(double spacing, std::uint64_t seed) const {
  std::vector<Eigen::Vector3d> out;
  Random random(seed, 2);
  const double area = spacing * spacing;
  const auto many = [&](double of) { return static_cast<int>(of / area); };
  for (int i = 0; i < many(0.3 * 0.27); ++i) {  // mat, hidden under the pot
    const Eigen::Vector3d p(random.uniform(0, 0.3), random.uniform(-0.015, 0.255), 0);
    if ((p.head<2>() - pot).norm() > pot_foot_radius) out.push_back(p);
  }
  for (int i = 0; i < many(2 * std::numbers::pi * 0.05 * rim_height); ++i) {  // outer wall
    const double z = random.uniform(0, rim_height), turn = random.angle();
    const double r = pot_foot_radius + (rim_radius - pot_foot_radius) * z / rim_height;
    out.emplace_back(pot.x() + r * std::cos(turn), pot.y() + r * std::sin(turn), z);
  }
  const double inner = rim_radius - 0.002;
  for (int i = 0; i < many(2 * std::numbers::pi * inner * (rim_height - foot.z())); ++i) {  // inner wall
    const double turn = random.angle();
    out.emplace_back(pot.x() + inner * std::cos(turn), pot.y() + inner * std::sin(turn),
                     random.uniform(foot.z(), rim_height));
  }
  for (int i = 0; i < many(std::numbers::pi * inner * inner); ++i) {
    const double r = inner * std::sqrt(random.uniform()), turn = random.angle();
    const double x = pot.x() + r * std::cos(turn), y = pot.y() + r * std::sin(turn);
    // Crumbs: a fixed relief of some millimetres wavelength.
    const double relief = soil_roughness * (std::sin(x * 900) * std::cos(y * 700) + 0.5 * std::sin(y * 1700 + x * 300));
    out.emplace_back(x, y, soil(x, y) + relief);
  }
  return out;
}

struct CloudSettings {
  double spacing = 0.0012, noise = 0.0004;
  int floaters = 0;
  std::uint64_t seed = 1;
};

inline PointCloud cloud_of(const PottedPlant& plant, const CloudSettings& s = {}) {
  auto all = plant.plant_points(s.spacing, s.seed);
  const std::size_t of_plant = all.size();
  const auto scene = plant.scene_points(1.5 * s.spacing, s.seed);
  all.insert(all.end(), scene.begin(), scene.end());
  Random random(s.seed, 3);
  for (auto& p : all) p += s.noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  for (int i = 0; i < s.floaters; ++i)
    all.emplace_back(random.uniform(0, 0.3), random.uniform(0, 0.25), random.uniform(0.02, 0.6));
  PointCloud::Positions positions;
  std::vector<std::uint16_t> red, green, blue;
  for (std::size_t i = 0; i < all.size(); ++i) {
    positions.push_back(all[i].cast<float>());
    red.push_back(i < of_plant ? 70 * 257 : 110 * 257);
    green.push_back(i < of_plant ? 130 * 257 : 90 * 257);
    blue.push_back(i < of_plant ? 60 * 257 : 70 * 257);
  }
  PointCloud cloud(std::move(positions));
  cloud.set_column(arrays::red, red);
  cloud.set_column(arrays::green, green);
  cloud.set_column(arrays::blue, blue);
  cloud.facts["world_axes"] = "board";
  cloud.facts["scale_source"] = "board";
  return cloud;
}

}  // namespace bole::tests
