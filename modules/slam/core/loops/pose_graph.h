// Keyframe poses that agree best with odometry and loop closures.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "slam/core/loops/loops.h"

namespace bole::slam {

// What the graph holds two keyframes together with, and how well they agree with it in the end.
struct GraphEdge {
  std::size_t from = 0, to = 0;
  std::optional<std::size_t> loop;  // index; none: odometry
  double sigma_rad = 0, sigma = 0;  // of the turn and the shift, each axis
  double turn_rad = 0, shift = 0;   // residuals
  double weight = 1;                // by the robust kernel; 0 where the loop was refused
  // Norm of the residual in standard deviations.
  double sigmas() const { return std::hypot(turn_rad / sigma_rad, shift / sigma); }
};

struct PoseGraphResult {
  std::vector<Pose> T_map_keyframe;
  double initial_cost = 0, final_cost = 0;
  std::size_t doubted_loops = 0;  // loops to which the robust kernel gave less than a tenth of their weight
  // One per loop: 1 where it contradicts the others and the odometry so much that it must be another place. These loops
  // are left out of a second adjustment, which gives the poses.
  std::vector<std::uint8_t> refused;
  bool solved = true, settled = true;  // `solved`: there is a solution; `settled`: it converged within the iterations
  std::vector<GraphEdge> edges;        // odometry, then loops; empty without a solution
  // Warnings for the report: an adjustment that found no solution, or did not converge.
  std::vector<std::string> warnings;
};

// The first keyframe is fixed. Odometry edges join neighbours, and loops have a Cauchy kernel. Loops that contradict
// the rest are refused. Those that a person put in (Loop::by_hand) have no kernel and are never refused. Where more
// than a quarter of the loops would be refused, the odometry is trusted to 5 % of the distance instead of 1 %, and the
// kernel starts wide, so that many loops that agree prevail over a trajectory that slipped. Where an adjustment has no
// solution, the keyframes keep their poses and all loops are refused, with a warning. One that did not converge is
// used, with a warning. Throws Error{cancelled}.
PoseGraphResult optimise_pose_graph(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                    const Run& run);

// The loops that were not refused.
std::vector<Loop> kept_loops(const std::vector<Loop>& loops, const PoseGraphResult& result);

}  // namespace bole::slam
