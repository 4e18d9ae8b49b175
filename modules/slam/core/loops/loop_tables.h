// Odometry, loop closures and pose graph as tables, which can be looked at, changed and solved again.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "slam/core/loops/pose_graph.h"

namespace bole::slam {

// Accepted loop closures by their times. The columns x_m .. qw are the pose of the later keyframe in the axes of the
// earlier one.
Table loops_table(const std::vector<Loop>& loops, const std::vector<Keyframe>& keyframes);

// Adds the columns travelled_m, x_m .. qw to a table with a row per frame: the pose at the end of each frame by
// odometry alone, map axes.
void add_odometry_poses(const std::vector<Pose>& T_map_frame, Table& odometry);

// A candidate with what became of it in the end.
struct JudgedLoop {
  CheckedLoop checked;
  bool accepted = false;
  std::string reason;  // why it was refused, or who accepted it
  bool edited = false;
};

// The verdicts of a search after the pose graph; `graph` is null where it was not solved.
std::vector<JudgedLoop> judged(const std::vector<CheckedLoop>& checked, const PoseGraphResult* graph);

// A row per candidate: keyframes, frames (index in the scan) and times of both, found_by, score, way_m, correction_m,
// overlap, rms_m, conditioning, verified (whether registration confirmed it), verdict (accepted, refused), reason,
// state (auto, edited), residual_m and residual_deg against the poses of the keyframes, and the relative pose x_m ..
// qw.
Table candidates_table(const std::vector<JudgedLoop>& loops, const std::vector<Keyframe>& keyframes,
                       const std::vector<std::size_t>& frame_of_keyframe, const std::vector<Pose>& T_map_keyframe);

// A row per edge: both keyframes and their frames and times, kind (odometry, loop), information_turn (1/rad2) and
// information_shift (1/m2) of each axis, the residuals, and the weight by the robust kernel.
Table graph_table(const std::vector<GraphEdge>& edges, const std::vector<Keyframe>& keyframes,
                  const std::vector<std::size_t>& frame_of_keyframe);

// What the tables `odometry` and `loop_candidates` of slam.run hold of the pose graph.
struct StoredGraph {
  std::vector<std::size_t> frame;   // index in the scan of each row of the odometry
  std::vector<Pose> T_map_frame;    // its pose
  std::vector<Keyframe> keyframes;  // without features
  std::vector<std::size_t> frame_of_keyframe;
  std::vector<JudgedLoop> loops;
};
// Throws Error{bad_input} for tables without these columns, or with values that cannot be.
StoredGraph stored_graph(const Table& odometry, const Table& candidates);

}  // namespace bole::slam
