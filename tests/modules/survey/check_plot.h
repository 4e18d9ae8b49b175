// A small surveyed plot with everything that a check looks at, made from formulas, to be spoilt part by part.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "base/random.h"
#include "survey/core/check/check_survey.h"

namespace bole::survey::testing_data {

struct CheckPlot {
  PointCloud points;
  Trajectory trajectory;
  Table stems, plot, loops, targets;

  CheckInputs inputs() const {
    CheckInputs in;
    in.points = &points, in.trajectory = &trajectory, in.stems = &stems, in.plot = &plot;
    in.loops = &loops, in.targets = &targets;
    return in;
  }
};

struct PlotSpoil {
  std::function<bool(double x, double y)> no_ground = [](double, double) { return false; };
  std::function<bool(int lane)> no_lane = [](int) { return false; };
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();  // of the second pass
  double wall_noise_m = 0.012;
  double lean = 0;  // of every stem to the east, tangent
};

inline constexpr double plot_half_m = 10, lane_m = 5;

struct PlotMaker {
  explicit PlotMaker(std::uint64_t seed, PlotSpoil s = {}) : random(seed, 1), spoil(std::move(s)) {}

  CheckPlot make() {
    walk();
    ground();
    stand();
    finish();
    return plot;
  }

  void walk() {
    double t = 0;
    int lane = 0;
    for (double x = -plot_half_m; x <= plot_half_m + 0.1; x += lane_m, ++lane) {
      if (spoil.no_lane(lane)) continue;
      for (double s = -plot_half_m; s <= plot_half_m; s += 0.5, t += 0.5) {
        StampedPose pose;
        pose.time_s = t;
        pose.T_target_sensor.translation() = Eigen::Vector3d(x, lane % 2 == 0 ? s : -s, 1.7);
        plot.trajectory.poses.push_back(pose);
      }
    }
  }

  // A return with the place of the sensor and its pass, from every second or so of the nearby stretches of the walk.
  void add(const Eigen::Vector3d& p, double noise) {
    const auto& poses = plot.trajectory.poses;
    const auto i = static_cast<std::size_t>(random.index(static_cast<int>(poses.size())));
    const bool second = 2 * i >= poses.size();
    Eigen::Vector3d q = p + noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    if (second) q += spoil.slip;
    xyz.push_back(q.cast<float>());
    const Eigen::Vector3d from = poses[i].T_target_sensor.translation();
    sx.push_back(static_cast<float>(from.x())), sy.push_back(static_cast<float>(from.y()));
    pass.push_back(second ? 1 : 0);
    height.push_back(static_cast<float>(q.z()));
  }

  void ground() {
    constexpr double step = 0.12;
    for (double x = -plot_half_m; x <= plot_half_m; x += step)
      for (double y = -plot_half_m; y <= plot_half_m; y += step)
        if (!spoil.no_ground(x, y)) add({x, y, 0}, 0.01);
  }

  void stand() {
    std::vector<double> x, y, dbh, lean, azimuth, seen;
    std::vector<std::int64_t> id;
    for (double cx = -8; cx <= 8; cx += 4)
      for (double cy = -8; cy <= 8; cy += 4) {
        const double px = cx + random.uniform(-1, 1), py = cy + random.uniform(-1, 1), d = random.uniform(12, 40);
        tree(px, py, d / 200);
        id.push_back(static_cast<std::int64_t>(id.size()) + 1);
        x.push_back(px), y.push_back(py), dbh.push_back(d);
        const double lx = spoil.lean + random.normal(0, 0.02), ly = random.normal(0, 0.02);
        lean.push_back(std::atan(std::hypot(lx, ly)) * 180 / std::numbers::pi);
        azimuth.push_back(std::atan2(lx, ly) * 180 / std::numbers::pi);
        seen.push_back(1);
      }
    plot.stems.set("tree_id", id);
    set_fact(plot.stems.facts, facts::range_stretch, 0.01);
    plot.stems.set("x_m", x), plot.stems.set("y_m", y), plot.stems.set("dbh_cm", dbh);
    plot.stems.set("lean_deg", lean), plot.stems.set("lean_azimuth_deg", azimuth), plot.stems.set("height_seen", seen);
  }

  void tree(double px, double py, double r) {
    for (double z = 0.05; z < 6; z += 0.05)
      for (int k = 0; k < 24; ++k) {
        const double turn = random.angle();
        add({px + r * std::cos(turn), py + r * std::sin(turn), z}, spoil.wall_noise_m);
      }
  }

  void finish() {
    plot.points = PointCloud(std::move(xyz));
    plot.points.set_column(arrays::sensor_x, std::move(sx));
    plot.points.set_column(arrays::sensor_y, std::move(sy));
    plot.points.set_column(arrays::pass, std::move(pass));
    plot.points.set_column(arrays::height_above_ground, std::move(height));
    plot.plot = to_table({rectangle_area({0, 0}, 2 * plot_half_m, 2 * plot_half_m), 7.5});
    plot.targets.set("name", std::vector<std::string>{"centre", "north"});
    plot.targets.set("x_m", std::vector<double>{0, 0}), plot.targets.set("y_m", std::vector<double>{0, 8});
    add_loop(0.01);
  }

  // One between the first and the last pose, off by so much.
  void add_loop(double off_m) {
    const auto &a = plot.trajectory.poses.front(), &b = plot.trajectory.poses.back();
    const Eigen::Vector3d d =
        (a.T_target_sensor.inverse() * b.T_target_sensor).translation() + Eigen::Vector3d(off_m, 0, 0);
    const auto one = [&](const char* name, double v) { plot.loops.set(name, std::vector<double>{v}); };
    one("from_time_s", a.time_s), one("to_time_s", b.time_s);
    one("x_m", d.x()), one("y_m", d.y()), one("z_m", d.z());
    one("qx", 0), one("qy", 0), one("qz", 0), one("qw", 1);
  }

  Random random;
  PlotSpoil spoil;
  CheckPlot plot;
  PointCloud::Positions xyz;
  std::vector<float> sx, sy, height;
  std::vector<std::int32_t> pass;
};

}  // namespace bole::survey::testing_data
