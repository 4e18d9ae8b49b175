// Every switch of the SLAM engine. A preset is a set of values for these options, no code of its own.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::slam {

// Options that a preset decides stand at "preset" (texts) or 0 (numbers) until somebody sets them; resolved() fills
// them in.
struct SlamOptions {
  std::string preset = "best";
  std::string trajectory;  // TUM file with poses of the sensor; empty: estimate them

  double range_min_m = 0.6;
  double range_max_m = 60;

  // Decided by the preset.
  std::string features = "preset";
  std::string occlusion = "preset";
  double occlusion_step_m = 0;
  double query_spacing_m = 0;
  double map_spacing_m = 0;
  std::string first_guess = "preset";
  std::string deskew = "preset";
  int rounds = 0;
  int neighbour_keyframes = 0;
  std::string local_map = "preset";
  double keyframe_distance_m = 0;
  double keyframe_angle_deg = 0;
  std::string loops = "preset";
  std::string context_search = "preset";
  std::string loop_registration = "preset";
  double loop_overlap = 0;
  std::string weights = "preset";
  std::string solve = "preset";
  int refine_rounds = 0;

  // Registration.
  double cell_m = 0.1;
  double range_sigma_m = 0.02;
  double angle_sigma_deg = 0.06;
  double kernel_sigmas = 3;
  double continuity_sigma_m = 0.004;
  double continuity_sigma_deg = 0.05;
  double lost_overlap = 0.25;
  int lost_frames = 5;
  double least_observability = 2.3;
  double speed_max_m_s = 5;

  // Loops.
  double loop_radius_m = 3;
  double loop_path_m = 25;
  double loop_drift = 0.05;
  int context_rings = 20;
  int context_sectors = 60;
  double context_range_m = 40;
  double context_tau = 0.5;
  int context_candidates = 10;

  // The dense map.
  bool dense_map = true;
  double map_range_min_m = 0.8;
  double map_range_max_m = 25;
  double map_voxel_m = 0.015;
  int map_points_per_voxel = 1;
  double map_max_points_million = 20;
  double pass_radius_m = 8;
  double trajectory_rate_hz = 50;
};

const OptionTable& option_table(const SlamOptions*);

// The options with everything that was left to the preset filled in from its table. Throws Error{bad_input} for an
// unknown preset.
SlamOptions resolved(const SlamOptions& options);

}  // namespace bole::slam
