// The path of the sensor as a smooth curve through poses: cubic between nodes, with velocities from the neighbouring
// nodes (Catmull-Rom on positions and on rotation vectors). Linear interpolation between frames would lose millimetres
// to centimetres of a walking gait.
#pragma once

#include <array>
#include <vector>

#include "cloud/trajectory.h"
#include "slam/core/odometry/motion.h"

namespace bole::slam {

class Path {
 public:
  Path() = default;
  // Times must strictly increase. Throws Error{bad_input} with fewer than two poses.
  explicit Path(std::vector<StampedPose> nodes);

  const std::vector<StampedPose>& nodes() const { return nodes_; }
  double begin_s() const { return nodes_.front().time_s; }
  double end_s() const { return nodes_.back().time_s; }
  bool covers(double time_s, double margin_s = 0) const {
    return time_s >= begin_s() - margin_s && time_s <= end_s() + margin_s;
  }

  // Beyond the ends, the motion of the outermost piece continues.
  Pose at(double time_s) const;

  // The nodes that the pose at a time depends on, and how far a small displacement of each moves it: the weights sum to
  // 1. A piece between nodes i and i + 1 depends on i - 1 .. i + 2; at the ends of the path missing nodes have weight
  // 0.
  struct Influence {
    std::ptrdiff_t first = 0;  // node i - 1: may be -1
    std::array<double, 4> weight{};
  };
  Influence influence(double time_s) const;

  // Replaces the pose of a node; its time stays.
  void set_pose(std::size_t node, const Pose& T) { nodes_[node].T_target_sensor = T; }
  // Call after the last set_pose(): the velocities depend on the poses.
  void update_velocities();

  // Poses at an even rate from begin to end, both included.
  Trajectory sampled(double rate, Axes axes) const;

 private:
  struct Piece {
    std::size_t i;
    double u, dt;
  };
  Piece piece_at(double time_s) const;

  std::vector<StampedPose> nodes_;
  std::vector<Vector6d> velocities_;  // turn in sensor axes (rad/s), shift in map axes (m/s)
};

// A path through frames, with a node where each begins and ends. A begin less than `join_s` after the last end is
// merged with it. A frame whose motion has a shape also has one in its middle.
Path path_through_frames(const std::vector<FrameMotion>& motions, const std::vector<std::pair<double, double>>& spans_s,
                         double join_s = 0.02);

}  // namespace bole::slam
