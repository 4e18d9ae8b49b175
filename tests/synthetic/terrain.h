// A synthetic forest floor with known truth: slope, undulation, rocks, a fallen stem, shrubs, grass, stems, crowns,
// noise and low outliers.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole::synthetic {

struct TerrainRecipe {
  double size_m = 20;     // square, from -size/2 to size/2
  double slope_deg = 20;  // rising towards `aspect_deg` (counter-clockwise from x)
  double aspect_deg = 30;
  double undulation_m = 0.3;   // amplitude of waves of 9 and 13 m
  double ground_per_m2 = 400;  // ground points
  double noise_m = 0.02;       // standard deviation along z
  double grass_share = 0;      // of ground points lifted by an exponential height of mean grass_m
  double grass_m = 0.10;
  int rocks = 0;                 // half-spheres of radius 0.3 to 0.6 m
  int fallen_stems = 0;          // 6 m long, 0.15 m thick radius
  int shrubs = 0;                // 1 to 2 m high balls of leaves, ground below them hidden
  int stems = 0;                 // radius 0.12 m, 8 m high, with a crown from 6 m up
  double low_outlier_share = 0;  // of all points, 0.5 to 6 m below ground
  unsigned seed = 1;
};

class Terrain {
 public:
  explicit Terrain(const TerrainRecipe& recipe) : r_(recipe), random_(recipe.seed) {}

  double height(double x, double y) const {
    const double a = r_.aspect_deg * std::numbers::pi / 180, rise = std::tan(r_.slope_deg * std::numbers::pi / 180);
    return rise * (std::cos(a) * x + std::sin(a) * y) +
           r_.undulation_m * (std::sin(2 * std::numbers::pi * x / 9.0) * std::cos(2 * std::numbers::pi * y / 13.0));
  }

  // Where the stems of the last cloud stand.
  std::vector<Eigen::Vector2d> stems() const {
    std::vector<Eigen::Vector2d> out;
    for (const auto& s : stems_) out.emplace_back(s.x, s.y);
    return out;
  }

  // Points in random order; `labels` (when given) gets 2 for ground, 7 for low outliers, 1 for the rest.
  PointCloud cloud(std::vector<int>* labels = nullptr) {
    make_objects();
    points_.clear();
    labels_.clear();
    const auto n = static_cast<std::size_t>(r_.ground_per_m2 * r_.size_m * r_.size_m);
    points_.reserve(n * 2);
    for (std::size_t i = 0; i < n; ++i) add_ground_shot();
    for (const auto& s : stems_) add_stem(s);
    const auto outliers = static_cast<std::size_t>(r_.low_outlier_share * static_cast<double>(points_.size()));
    for (std::size_t i = 0; i < outliers; ++i) {
      const double x = place(), y = place();
      add(x, y, height(x, y) - uniform(0.5, 6.0), 7);
    }
    if (labels) *labels = labels_;
    return PointCloud(points_);
  }

 private:
  struct Ball {
    double x, y, radius, top;
  };
  struct Log {
    double x, y, dx, dy;
  };

  double uniform(double a, double b) { return a + (b - a) * std::uniform_real_distribution<double>(0, 1)(random_); }
  double place() { return uniform(-r_.size_m / 2, r_.size_m / 2); }
  double gauss() { return std::normal_distribution<double>(0, 1)(random_); }
  void add(double x, double y, double z, int label) {
    points_.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    labels_.push_back(label);
  }

  void make_objects() {
    random_.seed(r_.seed);
    rocks_.clear();
    shrubs_.clear();
    logs_.clear();
    stems_.clear();
    for (int i = 0; i < r_.rocks; ++i) rocks_.push_back({place(), place(), uniform(0.3, 0.6), 0});
    for (int i = 0; i < r_.shrubs; ++i) shrubs_.push_back({place(), place(), uniform(0.5, 0.9), uniform(1.0, 2.0)});
    for (int i = 0; i < r_.fallen_stems; ++i) {
      const double a = uniform(0, 2 * std::numbers::pi);
      logs_.push_back({place(), place(), std::cos(a), std::sin(a)});
    }
    for (int i = 0; i < r_.stems; ++i) stems_.push_back({place(), place(), 0.12, 8});
  }

  // What a ray from above meets at a random place: shrub, rock, fallen stem, or ground (hidden within stems).
  void add_ground_shot() {
    const double x = place(), y = place(), g = height(x, y);
    for (const auto& s : stems_)
      if (std::hypot(x - s.x, y - s.y) < s.radius) return;
    for (const auto& s : shrubs_)
      if (std::hypot(x - s.x, y - s.y) < s.radius) return add(x, y, g + uniform(0.15, s.top), 1);
    for (const auto& s : rocks_)
      if (const double d = std::hypot(x - s.x, y - s.y); d < s.radius)
        return add(x, y, height(s.x, s.y) + std::sqrt(s.radius * s.radius - d * d) + r_.noise_m * gauss(), 1);
    for (const auto& l : logs_) {
      const double along = (x - l.x) * l.dx + (y - l.y) * l.dy, across = (x - l.x) * l.dy - (y - l.y) * l.dx;
      constexpr double radius = 0.15;
      if (std::abs(along) < 3 && std::abs(across) < radius)
        return add(x, y, g + radius + std::sqrt(radius * radius - across * across) + r_.noise_m * gauss(), 1);
    }
    const bool grass = uniform(0, 1) < r_.grass_share;
    add(x, y, g + r_.noise_m * gauss() + (grass ? std::exponential_distribution<double>(1 / r_.grass_m)(random_) : 0.0),
        grass ? 1 : 2);
  }

  void add_stem(const Ball& s) {
    const double g = height(s.x, s.y);
    const auto n = static_cast<int>(r_.ground_per_m2 * 2 * std::numbers::pi * s.radius * s.top);
    for (int i = 0; i < n; ++i) {
      const double a = uniform(0, 2 * std::numbers::pi), z = uniform(-0.2, s.top);
      const double x = s.x + s.radius * std::cos(a), y = s.y + s.radius * std::sin(a);
      if (g + z > height(x, y)) add(x, y, g + z, 1);
    }
    for (int i = 0; i < n; ++i) add(s.x + 0.8 * gauss(), s.y + 0.8 * gauss(), g + uniform(6, 9), 1);
  }

  TerrainRecipe r_;
  std::mt19937 random_;
  std::vector<Ball> rocks_, shrubs_, stems_;
  std::vector<Log> logs_;
  PointCloud::Positions points_;
  std::vector<int> labels_;
};

}  // namespace bole::synthetic
