// The sensor's pose as a smooth function of time: the route walked by a person who carries it.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/transform.h"
#include "cloud/trajectory.h"
#include "sim/core/plot/terrain.h"

namespace bole::sim {

// person: held in the hand; robot: on tracks, tilted with the ground under them, with vibration in place of a gait;
// backpack: on a frame on the back, which steps and rolls with the trunk but has no wandering hand.
enum class Carrier { person, robot, backpack };
constexpr std::array<std::string_view, 3> choice_names(Carrier) { return {"person", "robot", "backpack"}; }

struct WalkParameters {
  double speed_m_s = 1.0;
  double sensor_height_m = 1.7;
  double gait = 1.0;            // 1: an ordinary step; 0: gliding
  double stand_still_s = 2.5;   // at the start
  std::optional<double> max_s;  // longest recording; left open: until the end of the route
  double turn_rad = 0;          // on the spot, after standing still, at up to 90 deg/s
  Carrier carrier = Carrier::person;
  double mount_tilt_rad = 0;  // of the sensor in its mount, forward down; pi: upside down
};

class Walk {
 public:
  // Spacing of route points that the splines are made for.
  static constexpr double step_m = 0.25;

  Walk(const std::vector<Eigen::Vector2d>& route, const Terrain& terrain, const WalkParameters& parameters,
       std::uint64_t seed);

  double duration_s() const { return duration_s_; }
  double length_m() const { return length_m_; }
  // T_plot_sensor at a time since the start of the recording, 0 to duration_s().
  Pose pose(double time_s) const;
  // Direction in which the carrier goes, counter-clockwise from east.
  double heading_rad(double time_s) const;
  // Phase of the left and right step, and how much of a step there is (0 standing, 1 at full speed).
  double stride_rad(double time_s) const;
  double pace(double time_s) const { return progress(time_s).pace; }
  Carrier carrier() const { return parameters_.carrier; }
  Trajectory trajectory(double rate_hz, double epoch_s) const;

 private:
  struct Progress {
    double distance_m = 0, pace = 0;  // pace: 0 standing, 1 at full speed
  };
  struct Swing {  // a slow wandering of the hand
    std::array<double, 3> amplitude{}, frequency_hz{}, phase{};
    double at(double t) const;
  };
  Progress progress(double t) const;
  double turned_rad(double t) const;
  Pose robot_pose(const Eigen::Vector4d& knot, double pace, double t) const;
  Eigen::Matrix3d mount() const;  // of the sensor in its carrier
  Swing make_swing(double size, class Random& random) const;

  WalkParameters parameters_;
  Terrain terrain_;
  std::vector<Eigen::Vector4d> knots_;  // x, y, z, heading: control points of a uniform cubic B-spline, one per step_m
  double duration_s_ = 0, length_m_ = 0, full_speed_s_ = 0, ease_s_ = 1.5, turn_s_ = 0;
  double step_hz_ = 1.8, mount_yaw_rad_ = 0;
  std::array<double, 4> phases_{};
  std::array<Swing, 4> swings_;  // roll, pitch, yaw, height
};

}  // namespace bole::sim
