// A synthetic plot with stems, two retro-reflective targets and strong clutter, in plot axes and with known truth.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/transform.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"

namespace bole::synthetic {

struct TargetPlotRecipe {
  double slope_deg = 20;
  double north_distance_m = 16;
  int stems = 50;
  double lean_sd_deg = 1.0;  // per axis
  bool centre_target = true, north_target = true;
  bool clutter = true;  // a sign, a jacket, glints
  bool intensity = true, sensor_positions = true;
  double noise_m = 0.02;
  double bend_m = 0;           // drift of the map along the walk, in the targets only
  bool moving_jacket = false;  // a helper beside the walk, 2 m ahead of the sensor
  unsigned seed = 1;
};

struct TargetPlot {
  PointCloud cloud;
  Trajectory trajectory;
};

class TargetPlotMaker {
 public:
  explicit TargetPlotMaker(const TargetPlotRecipe& recipe)
      : r_(recipe), random_(recipe.seed), slope_(std::tan(recipe.slope_deg * std::numbers::pi / 180)) {}

  static constexpr double half_m = 18;

  // The plot seen in axes T_map_plot away from its own.
  TargetPlot make(const Pose& T_map_plot) {
    make_walk();
    ground();
    for (int i = 0; i < r_.stems; ++i) stem();
    if (r_.centre_target) target({0, 0});
    if (r_.north_target) target({0, r_.north_distance_m});
    if (r_.clutter) clutter();
    return moved(T_map_plot);
  }

  double height(double x, double y) const { return slope_ * (0.8 * x + 0.6 * y); }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  double gauss() { return std::normal_distribution<double>(0, 1)(random_); }

  void make_walk() {
    for (int i = 0; i <= 200; ++i) {  // a spiral from the centre, then back and forth
      const double s = i / 200.0, a = s * 6 * std::numbers::pi, radius = 0.8 + 13 * s;
      const Eigen::Vector3d p(radius * std::cos(a), radius * std::sin(a), 0);
      Pose pose = Pose::Identity();
      pose.translation() = Eigen::Vector3d(p.x(), p.y(), height(p.x(), p.y()) + 1.6);
      walk_.push_back(pose);
    }
  }

  void add(const Eigen::Vector3d& p, double intensity, const Pose& sensor) {
    points_.push_back(p + r_.noise_m * Eigen::Vector3d(gauss(), gauss(), gauss()));
    intensity_.push_back(static_cast<float>(intensity));
    sensors_.push_back(sensor.translation());
  }
  const Pose& any_pose() { return walk_[std::uniform_int_distribution<std::size_t>(0, walk_.size() - 1)(random_)]; }

  void ground() {
    for (int i = 0; i < 150'000; ++i) {
      const double x = uniform(-half_m, half_m), y = uniform(-half_m, half_m);
      const double lift = uniform(0, 1) < 0.15 ? std::exponential_distribution<double>(10)(random_) : 0.0;
      add({x, y, height(x, y) + lift}, uniform(5, 60), any_pose());
    }
  }

  void stem() {
    double x = 0, y = 0;
    do {
      x = uniform(-half_m, half_m);
      y = uniform(-half_m, half_m);
    } while (std::hypot(x, y) < 1.5 || std::hypot(x, y - r_.north_distance_m) < 1.5);
    const double lean = std::numbers::pi / 180 * r_.lean_sd_deg, lx = lean * gauss(), ly = lean * gauss(),
                 radius = uniform(0.07, 0.2);
    for (int i = 0; i < 3000; ++i) {
      const double h = uniform(0, 9), a = uniform(0, 2 * std::numbers::pi), taper = radius * (1 - h / 25);
      add({x + lx * h + taper * std::cos(a), y + ly * h + taper * std::sin(a), height(x, y) + h}, uniform(5, 80),
          any_pose());
    }
    for (int i = 0; i < 3000; ++i)
      add({x + lx * 8 + 1.2 * gauss(), y + ly * 8 + 1.2 * gauss(), height(x, y) + uniform(7, 12)}, uniform(1, 30),
          any_pose());
  }

  // A cylinder 0.2 m wide and 0.3 m high, seen from within 15 m; only the side towards the sensor returns.
  void target(const Eigen::Vector2d& at) {
    for (const auto& pose : walk_) {
      const Eigen::Vector2d to_sensor = pose.translation().head<2>() - at;
      if (to_sensor.norm() > 15) continue;
      const double towards = std::atan2(to_sensor.y(), to_sensor.x());
      const double bent = r_.bend_m * static_cast<double>(&pose - walk_.data()) / static_cast<double>(walk_.size());
      for (int i = 0; i < 12; ++i) {
        const double a = towards + std::asin(uniform(-1, 1));
        add({at.x() + bent + 0.1 * std::cos(a), at.y() + 0.1 * std::sin(a), height(at.x(), at.y()) + uniform(1.2, 1.5)},
            uniform(180, 255), pose);
      }
    }
  }

  void clutter() {
    for (int i = 0; i < 3000; ++i)
      add({8.0 + uniform(-0.6, 0.6), -7.0, height(8, -7) + uniform(1, 2)}, uniform(150, 250),
          any_pose());  // a sign, too large
    for (int i = 0; i < 400; ++i)
      add({-6.0 + uniform(-0.2, 0.2), 5.0, height(-6, 5) + uniform(1, 1.5)}, uniform(110, 250),
          walk_[60]);  // a jacket, seen from one place
    if (r_.moving_jacket) moving_jacket();
    for (int i = 0; i < 30; ++i)
      add({uniform(-half_m, half_m), uniform(-half_m, half_m), uniform(0, 5)}, 140, any_pose());  // glints
  }

  void moving_jacket() {
    for (std::size_t k = 0; k + 1 < walk_.size(); ++k)
      for (double u = 0; u < 1; u += 0.02) {
        Pose pose = walk_[k];
        pose.translation() += u * (walk_[k + 1].translation() - walk_[k].translation());
        add(pose.translation() + Eigen::Vector3d(2 + uniform(-0.2, 0.2), 0, uniform(-0.3, 0)), uniform(110, 250), pose);
      }
  }

  TargetPlot moved(const Pose& T_map_plot) {
    TargetPlot out;
    PointCloud::Positions positions;
    std::vector<float> sx, sy, sz;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      positions.push_back((T_map_plot * points_[i]).cast<float>());
      const Eigen::Vector3f s = (T_map_plot * sensors_[i]).cast<float>();
      sx.push_back(s.x());
      sy.push_back(s.y());
      sz.push_back(s.z());
    }
    out.cloud = PointCloud(std::move(positions));
    out.cloud.axes = Axes::map;
    if (r_.intensity) out.cloud.set_column(arrays::intensity, intensity_);
    if (r_.sensor_positions) {
      out.cloud.set_column(arrays::sensor_x, std::move(sx));
      out.cloud.set_column(arrays::sensor_y, std::move(sy));

      out.cloud.set_column(arrays::sensor_z, std::move(sz));
    }
    for (std::size_t i = 0; i < walk_.size(); ++i)
      out.trajectory.poses.push_back({static_cast<double>(i), T_map_plot * walk_[i]});
    return out;
  }

  TargetPlotRecipe r_;
  std::mt19937 random_;
  double slope_;
  std::vector<Pose> walk_;
  std::vector<Eigen::Vector3d> points_, sensors_;
  std::vector<float> intensity_;
};

}  // namespace bole::synthetic
