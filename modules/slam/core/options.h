// The options of the SLAM engine. A preset is a set of values for some of them and has no code of its own.
#pragma once

#include <optional>
#include <string>

#include "base/option.h"
#include "slam/core/choices.h"

namespace bole::slam {

// The options that a preset decides. `Of<T>` is std::optional<T> in a document (no value: as the preset says), T in a
// run, and one T for each preset in the table of presets.
template <template <class> class Of>
struct PresetFields {
  Of<FeatureKind> features{};
  Of<Occlusion> occlusion{};
  Of<double> occlusion_step{};
  Of<double> query_spacing{};
  Of<double> map_spacing{};
  Of<FirstGuess> first_guess{};
  Of<Deskew> deskew{};
  Of<int> iterations{};
  Of<int> neighbour_keyframes{};
  Of<LocalMapKind> local_map{};
  Of<double> keyframe_distance{};
  Of<double> keyframe_angle_deg{};
  Of<LoopSource> loops{};
  Of<ContextSearchKind> context_search{};
  Of<ContextDistance> context_distance{};
  Of<LoopRegistrationKind> loop_registration{};
  Of<int> loop_stretch{};
  Of<LoopAcceptance> loop_acceptance{};
  Of<double> loop_overlap{};
  Of<Weights> weights{};
  Of<Solve> solve{};
  Of<int> refine_iterations{};
  Of<InertialUse> inertial{};
};

// The options that have the same default with every preset.
struct CommonOptions {
  Preset preset = Preset::best;
  std::string trajectory;  // TUM file with poses of the sensor; empty: estimate them

  double min_range = 0.6;
  double max_range = 60;

  // Registration.
  double cell_size = 0.1;
  double range_sigma = 0.02;
  double angle_sigma_deg = 0.06;
  double kernel_sigmas = 3;
  double continuity_sigma = 0.004;
  double continuity_sigma_deg = 0.05;
  double lost_overlap = 0.25;
  int lost_frames = 5;
  double min_observability = 2.3;
  double max_speed = 5;

  // The inertial unit.
  double inertial_trust = 0.1;
  double inertial_bridge = 0.2;
  std::optional<double> inertial_offset;  // open: estimated where the mount is not known either, else none

  // Loops.
  double loop_radius = 3;
  double loop_path = 25;
  double loop_drift = 0.05;
  double loop_fitness = 0.55;
  int context_rings = 20;
  int context_sectors = 60;
  double context_range = 40;
  double context_tau = 0.5;
  int context_candidates = 10;

  // The dense map.
  bool dense_map = true;
  double map_min_range = 0.8;
  double map_max_range = 25;
  double map_voxel = 0.015;
  int map_points_per_voxel = 1;
  double map_max_points_million = 20;
  double pass_radius = 8;
  double trajectory_rate = 50;
};

template <class T>
using Plain = T;

// As in a document.
struct SlamOptions : CommonOptions, PresetFields<std::optional> {};
// As used in a run.
struct SlamSettings : CommonOptions, PresetFields<Plain> {};

const OptionTable& option_table(const SlamOptions*);

// The options as a run uses them.
SlamSettings resolved(const SlamOptions& options);
// The same as options: all those that were left to the preset have its value.
SlamOptions filled_in(const SlamOptions& options);

}  // namespace bole::slam
