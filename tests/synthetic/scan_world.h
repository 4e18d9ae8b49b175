// A small world of exact shapes, and a spinning sensor that moves through it: scan frames with known truth for tests.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/transform.h"
#include "cloud/scan_frame.h"
#include "cloud/trajectory.h"

namespace bole::synthetic {

struct Plane {
  Eigen::Vector3d normal;
  double offset;  // normal . x = offset
};
struct Cylinder {
  Eigen::Vector3d base, axis;  // axis of unit length
  double radius, length;
};
struct Box {
  Eigen::Vector3d low, high;
};

struct World {
  std::vector<Plane> planes;
  std::vector<Cylinder> cylinders;
  std::vector<Box> boxes;

  // Range of the first hit along a unit direction; infinite when there is none.
  double range(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    double best = std::numeric_limits<double>::infinity();
    const auto take = [&](double t) {
      if (t > 1e-6 && t < best) best = t;
    };
    for (const auto& p : planes) take((p.offset - p.normal.dot(from)) / p.normal.dot(direction));
    for (const auto& c : cylinders) take(hit(c, from, direction));
    for (const auto& b : boxes) take(hit(b, from, direction));
    return best;
  }

 private:
  static double hit(const Cylinder& c, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d o = from - c.base;
    const Eigen::Vector3d across = direction - direction.dot(c.axis) * c.axis, offset = o - o.dot(c.axis) * c.axis;
    const double a = across.squaredNorm(), b = across.dot(offset), q = offset.squaredNorm() - c.radius * c.radius,
                 d = b * b - a * q;
    if (d < 0 || a < 1e-12) return -1;
    const double t = (-b - std::sqrt(d)) / a, h = (o + t * direction).dot(c.axis);
    return h >= 0 && h <= c.length ? t : -1;
  }
  static double hit(const Box& box, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const Eigen::Array3d a = (box.low - from).array() / direction.array(),
                         b = (box.high - from).array() / direction.array();
    const double near = a.min(b).maxCoeff(), far = a.max(b).minCoeff();
    return near <= far ? near : -1;
  }
};

struct SpinningSensor {
  std::vector<double> elevations_rad;  // lowest first
  int columns = 1800;                  // firings per revolution
  double period_s = 0.1;
  double range_max_m = 80;
  double range_noise_m = 0;

  static SpinningSensor even(int lines, double lowest_deg, double highest_deg, int columns) {
    SpinningSensor s;
    for (int i = 0; i < lines; ++i)
      s.elevations_rad.push_back((lowest_deg + (highest_deg - lowest_deg) * i / std::max(1, lines - 1)) *
                                 std::numbers::pi / 180);
    s.columns = columns;
    return s;
  }
  // The uneven lines of the VLP-32C: close together about the horizon, wide below.
  static SpinningSensor vlp32c(int columns = 1800) {
    SpinningSensor s;
    for (const double deg : {-25.0, -15.639, -11.31, -8.843, -7.254, -6.148, -5.333, -4.667, -4.0,   -3.667, -3.333,
                             -3.0,  -2.667,  -2.333, -2.0,   -1.667, -1.333, -1.0,   -0.667, -0.333, 0.0,    0.333,
                             0.667, 1.0,     1.333,  1.667,  2.333,  3.333,  4.667,  7.0,    10.333, 15.0})
      s.elevations_rad.push_back(deg * std::numbers::pi / 180);
    s.columns = columns;
    return s;
  }
};

// Frames are cast on demand; the same index gives the same frame.
class SyntheticScan : public FrameSource {
 public:
  using Motion = std::function<Pose(double time_s)>;
  SyntheticScan(World world, SpinningSensor sensor, Motion T_world_sensor, std::size_t frames, unsigned seed = 1)
      : world_(std::move(world)),
        sensor_(std::move(sensor)),
        motion_(std::move(T_world_sensor)),
        frames_(frames),
        seed_(seed) {}

  std::function<void(std::size_t index, ScanFrame& frame)> spoil;  // applied to each frame that is read
  std::vector<double> start_times_s;                               // of each frame; empty: one after the other

  std::size_t size() const override { return frames_; }
  double frame_time_s(std::size_t index) const override {
    return start_times_s.empty() ? static_cast<double>(index) * sensor_.period_s : start_times_s[index];
  }
  int rings() const override { return static_cast<int>(sensor_.elevations_rad.size()); }
  std::vector<double> ring_elevations_rad() const override { return sensor_.elevations_rad; }
  std::string sensor_model() const override { return "synthetic"; }
  Facts facts() const override {
    return {{"sensor", "synthetic"}, {"range_noise_m", number_text(sensor_.range_noise_m)}};
  }
  std::string description() const override { return "synthetic scan"; }
  std::string locator() const override { return "{}"; }
  Pose truth(double time_s) const { return motion_(time_s); }

  Trajectory true_trajectory(double rate_hz) const {
    Trajectory t;
    const double end_s = frame_time_s(frames_ - 1) + sensor_.period_s;
    for (double time_s = 0; time_s <= end_s + 1e-9; time_s += 1 / rate_hz) t.poses.push_back({time_s, motion_(time_s)});
    return t;
  }

  void read(std::size_t index, ScanFrame& frame) const override {
    frame.clear();
    frame.start_time_s = frame_time_s(index);
    std::mt19937 random(seed_ * 1000003u + static_cast<unsigned>(index));
    std::normal_distribution<double> noise(0, sensor_.range_noise_m > 0 ? sensor_.range_noise_m : 1);
    for (int c = 0; c < sensor_.columns; ++c) {
      const double offset_s = sensor_.period_s * c / sensor_.columns;
      const double azimuth = -2 * std::numbers::pi * c / sensor_.columns;  // clockwise from behind
      const Pose T = motion_(frame.start_time_s + offset_s);
      for (std::size_t r = 0; r < sensor_.elevations_rad.size(); ++r) {
        const double e = sensor_.elevations_rad[r];
        const Eigen::Vector3d direction(-std::cos(e) * std::cos(azimuth), -std::cos(e) * std::sin(azimuth),
                                        std::sin(e));
        double range = world_.range(T.translation(), T.linear() * direction);
        if (!(range <= sensor_.range_max_m)) continue;
        if (sensor_.range_noise_m > 0) range += noise(random);
        frame.positions.push_back((range * direction).cast<float>());
        frame.time_offset_s.push_back(static_cast<float>(offset_s));
        frame.ring.push_back(static_cast<std::uint16_t>(r));
        frame.intensity.push_back(20);
        frame.return_number.push_back(1);
      }
    }
    frame.end_time_s = frame.start_time_s + sensor_.period_s * (sensor_.columns - 1) / sensor_.columns;
    if (spoil) spoil(index, frame);
  }

 private:
  World world_;
  SpinningSensor sensor_;
  Motion motion_;
  std::size_t frames_;
  unsigned seed_;
};

// A plot of leaning trunks on sloping ground, with a few rocks, about the origin.
inline World trunks(double half_size_m, double spacing_m, unsigned seed = 7) {
  World world;
  const Eigen::Vector3d up = Eigen::Vector3d(-0.05, 0.03, 1).normalized();
  world.planes.push_back({up, 0});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.35 * spacing_m, 0.35 * spacing_m), radius(0.06, 0.16),
      lean(-0.06, 0.06);
  const auto ground = [&](double x, double y) { return -(up.x() * x + up.y() * y) / up.z(); };
  for (double x = -half_size_m; x <= half_size_m; x += spacing_m)
    for (double y = -half_size_m; y <= half_size_m; y += spacing_m) {
      const double tx = x + jitter(random), ty = y + jitter(random);
      world.cylinders.push_back({{tx, ty, ground(tx, ty) - 0.2},
                                 Eigen::Vector3d(lean(random), lean(random), 1).normalized(),
                                 radius(random),
                                 9});
    }
  for (int i = 0; i < 6; ++i) {
    const double bx = jitter(random) * half_size_m / spacing_m * 2, by = jitter(random) * half_size_m / spacing_m * 2;
    const Eigen::Vector3d at(bx, by, ground(bx, by));
    world.boxes.push_back({at - Eigen::Vector3d(0.3, 0.2, 0.3), at + Eigen::Vector3d(0.3, 0.4, 0.35)});
  }
  return world;
}

// Walking pace along a circle with the bob, sway and turns of a walking person; still for `still_s` first.
inline Pose walk_on_circle(double time_s, double radius_m, double speed_m_s, double gait = 1, double still_s = 1) {
  const double pi = std::numbers::pi;
  const double walked_s = std::max(0.0, time_s - still_s);
  const double moving = std::min(1.0, walked_s / 0.7), eased = moving * moving * (3 - 2 * moving);
  const double way_m = walked_s < 0.7 ? speed_m_s * 0.7 * (std::pow(moving, 3) - 0.5 * std::pow(moving, 4))
                                      : speed_m_s * (walked_s - 0.35);
  const double a = way_m / radius_m, g = gait * eased;
  const double step = 2 * pi * 1.9 * walked_s, stride = pi * 1.9 * walked_s;
  Pose T = Pose::Identity();
  T.translation() = Eigen::Vector3d(radius_m * std::cos(a) + 0.02 * g * std::sin(stride) * std::cos(a),
                                    radius_m * std::sin(a) + 0.02 * g * std::sin(stride) * std::sin(a),
                                    1.7 + 0.025 * g * std::sin(step));
  T.linear() = rotation_from_rpy(0.025 * g * std::sin(stride + 0.4), 0.02 * g * std::sin(step + 1.1),
                                 a + pi / 2 + 0.05 * g * std::sin(stride + 2));
  return T;
}

}  // namespace bole::synthetic
