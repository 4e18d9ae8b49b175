#include "slam/core/options.h"

#include <array>
#include <span>

namespace bole {
namespace {

struct PresetValue {
  std::string_view option;
  OptionValue value;
};

struct Preset {
  std::string_view name;
  std::vector<PresetValue> values;
};

// SPEC A calls the first two "LOAM" and "improved LOAM"; SPEC D compares the next two.
const std::vector<Preset>& presets() {
  static const std::vector<Preset> table{
      {"loam",
       {{"features", "curvature"},
        {"occlusion", "far_side"},
        {"occlusion_step", 0.3},
        {"query_spacing", 0.4},
        {"map_spacing", 0.2},
        {"first_guess", "velocity"},
        {"deskew", "once"},
        {"rounds", std::int64_t{12}},
        {"neighbour_keyframes", std::int64_t{60}},
        {"keyframe_distance", 0.3},
        {"keyframe_angle", 10.0},
        {"loops", "none"},
        {"loop_registration", "features"},
        {"weights", "thickness"},
        {"solve", "joint"},
        {"refine_rounds", std::int64_t{-1}}}},
      {"forest",
       {{"features", "curvature"},
        {"occlusion", "both_sides"},
        {"occlusion_step", 0.3},
        {"query_spacing", 0.4},
        {"map_spacing", 0.2},
        {"first_guess", "last_frame"},
        {"deskew", "twice"},
        {"rounds", std::int64_t{12}},
        {"neighbour_keyframes", std::int64_t{60}},
        {"keyframe_distance", 0.3},
        {"keyframe_angle", 10.0},
        {"loops", "both"},
        {"loop_registration", "features"},
        {"weights", "priors"},
        {"solve", "joint"},
        {"refine_rounds", std::int64_t{-1}}}},
      {"lego_loam",
       {{"features", "ground"},
        {"occlusion", "far_side"},
        {"occlusion_step", 0.3},
        {"query_spacing", 0.4},
        {"map_spacing", 0.2},
        {"first_guess", "velocity"},
        {"deskew", "once"},
        {"rounds", std::int64_t{12}},
        {"neighbour_keyframes", std::int64_t{60}},
        {"keyframe_distance", 0.3},
        {"keyframe_angle", 10.0},
        {"loops", "odometry"},
        {"loop_registration", "icp"},
        {"weights", "thickness"},
        {"solve", "two_step"},
        {"refine_rounds", std::int64_t{-1}}}},
      {"orchard",
       {{"features", "ground"},
        {"occlusion", "far_side"},
        {"occlusion_step", 0.3},
        {"query_spacing", 0.4},
        {"map_spacing", 0.2},
        {"first_guess", "velocity"},
        {"deskew", "once"},
        {"rounds", std::int64_t{12}},
        {"neighbour_keyframes", std::int64_t{60}},
        {"keyframe_distance", 0.3},
        {"keyframe_angle", 10.0},
        {"loops", "context"},
        {"loop_registration", "ndt_icp"},
        {"weights", "thickness"},
        {"solve", "two_step"},
        {"refine_rounds", std::int64_t{-1}}}},
      {"best",
       {{"features", "sampled"},
        {"occlusion", "both_sides"},
        {"occlusion_step", 0.3},
        {"query_spacing", 0.6},
        {"map_spacing", 0.1},
        {"first_guess", "velocity"},
        {"deskew", "elastic"},
        {"rounds", std::int64_t{12}},
        {"neighbour_keyframes", std::int64_t{400}},
        {"keyframe_distance", 0.3},
        {"keyframe_angle", 10.0},
        {"loops", "odometry"},
        {"loop_registration", "features"},
        {"weights", "thickness"},
        {"solve", "joint"},
        {"refine_rounds", std::int64_t{3}}}},
  };
  return table;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& p : presets()) names.emplace_back(p.name);
  return names;
}

void check(const SlamOptions& o) {
  if (o.range_min_m >= o.range_max_m)
    throw bad_input("range_min is " + number_text(o.range_min_m) + " m",
                    "less than range_max, " + number_text(o.range_max_m) + " m");
  if (o.map_range_min_m >= o.map_range_max_m)
    throw bad_input("map_range_min is " + number_text(o.map_range_min_m) + " m",
                    "less than map_range_max, " + number_text(o.map_range_max_m) + " m");
  if (o.deskew == "elastic" && o.solve == "two_step")
    throw bad_input("solve is two_step with deskew elastic", "joint with elastic frames",
                    "Set solve to joint, or deskew to once");
}

}  // namespace

const OptionTable& option_table(const SlamOptions*) {
  using S = SlamOptions;
  using D = Option<S, double>;
  using I = Option<S, int>;
  using T = Option<S, std::string>;
  static const OptionTable table = make_option_table<S>(
      {
          T{"preset", &S::preset, TextKind::choice, preset_names(), Tier::basic,
            "Which system: loam (baseline), forest (improved LOAM for forest plots), lego_loam (ground-aware "
            "baseline), "
            "orchard (the same with loops by Scan Context and NDT-ICP), best (elastic frames and a final adjustment of "
            "the whole path)."},
          T{"trajectory",
            &S::trajectory,
            TextKind::input_path,
            {},
            Tier::basic,
            "TUM file with sensor poses to map with instead of estimating them; its clock is that of the scan."},
          D{"range_min",
            &S::range_min_m,
            Unit::metre,
            {0, 10},
            Tier::advanced,
            "Nearer returns are the bearer and are left out."},
          D{"range_max",
            &S::range_max_m,
            Unit::metre,
            {1, 300},
            Tier::advanced,
            "Farther returns take no part in the registration."},

          T{"features",
            &S::features,
            TextKind::choice,
            {"preset", "curvature", "ground", "sampled"},
            Tier::advanced,
            "Points that are registered: edges and planes by curvature along the scan line, the same with planes from "
            "the "
            "ground and edges from things that stand on it (LeGO-LOAM), or all points thinned on a grid."},
          T{"occlusion",
            &S::occlusion,
            TextKind::choice,
            {"preset", "none", "far_side", "both_sides"},
            Tier::advanced,
            "Edges rejected beside a step in range: none, those on the farther side (LOAM), or on both sides, so that "
            "the outline of a trunk never becomes a line."},
          D{"occlusion_step",
            &S::occlusion_step_m,
            Unit::metre,
            {0, 5},
            Tier::advanced,
            "Step in range between neighbours of a scan line that counts as occlusion; 0: as the preset says."},
          D{"query_spacing",
            &S::query_spacing_m,
            Unit::metre,
            {0, 5},
            Tier::advanced,
            "Grid on which the points to be registered are thinned; 0: as the preset says."},
          D{"map_spacing",
            &S::map_spacing_m,
            Unit::metre,
            {0, 5},
            Tier::advanced,
            "Grid on which the points of a key frame are thinned; 0: as the preset says."},
          T{"first_guess",
            &S::first_guess,
            TextKind::choice,
            {"preset", "velocity", "last_frame"},
            Tier::advanced,
            "Motion before registration: that of the frame before, or matched against the frame before."},
          T{"deskew",
            &S::deskew,
            TextKind::choice,
            {"preset", "none", "once", "twice", "elastic"},
            Tier::advanced,
            "Motion within the frame: ignored, from the first guess, again after a first registration, or estimated "
            "with it (begin and end pose)."},
          I{"rounds",
            &S::rounds,
            Unit::none,
            {0, 100},
            Tier::expert,
            "Most rounds of matching and solving per registration; 0: as the preset says."},
          I{"neighbour_keyframes",
            &S::neighbour_keyframes,
            Unit::none,
            {0, 100000},
            Tier::advanced,
            "Key frames nearest to the last one that make the local map; 0: as the preset says."},
          D{"keyframe_distance",
            &S::keyframe_distance_m,
            Unit::metre,
            {0, 20},
            Tier::advanced,
            "Way between key frames; 0: as the preset says."},
          D{"keyframe_angle",
            &S::keyframe_angle_deg,
            Unit::degree,
            {0, 180},
            Tier::advanced,
            "Turn between key frames; 0: as the preset says."},
          T{"loops",
            &S::loops,
            TextKind::choice,
            {"preset", "none", "odometry", "context", "both"},
            Tier::advanced,
            "Where to look for revisits: nowhere, where the estimated path comes near itself, where the surroundings "
            "look "
            "alike (Scan Context), or both."},
          T{"loop_registration",
            &S::loop_registration,
            TextKind::choice,
            {"preset", "features", "icp", "ndt_icp"},
            Tier::advanced,
            "How the relative pose of a revisit is found: by edges and planes, by closest points, or by normal "
            "distributions and then closest points."},
          T{"weights",
            &S::weights,
            TextKind::choice,
            {"preset", "thickness", "priors"},
            Tier::advanced,
            "What weighs a match: the thickness of the surface and the scatter of ranges, or the covariances of the "
            "points, from the sensor and from the poses that placed them (SPEC A7)."},
          T{"solve",
            &S::solve,
            TextKind::choice,
            {"preset", "joint", "two_step"},
            Tier::advanced,
            "All six unknowns from all features, or height, roll and pitch from planes and the others from edges "
            "(LeGO-LOAM; not with elastic frames)."},
          I{"refine_rounds",
            &S::refine_rounds,
            Unit::none,
            {-1, 20},
            Tier::advanced,
            "Rounds of the final adjustment of the whole path to the whole map; -1: none, 0: as the preset says."},

          D{"cell",
            &S::cell_m,
            Unit::metre,
            {0.02, 2},
            Tier::expert,
            "Finest cell of the distribution map; coarser levels double it."},
          D{"range_sigma",
            &S::range_sigma_m,
            Unit::metre,
            {0.001, 0.5},
            Tier::expert,
            "Standard deviation of a range, added to the thickness of a map surface."},
          D{"angle_sigma",
            &S::angle_sigma_deg,
            Unit::degree,
            {0.001, 5},
            Tier::expert,
            "Standard deviation of azimuth and elevation of a return (weights by priors)."},
          D{"kernel_sigmas",
            &S::kernel_sigmas,
            Unit::none,
            {0.5, 20},
            Tier::expert,
            "Scale of the robust kernel (Geman-McClure) in standard deviations."},
          D{"continuity_sigma",
            &S::continuity_sigma_m,
            Unit::metre,
            {0.0001, 1},
            Tier::expert,
            "How far a frame may begin from where the last one ended (elastic frames)."},
          D{"continuity_sigma_angle",
            &S::continuity_sigma_deg,
            Unit::degree,
            {0.001, 10},
            Tier::expert,
            "How much a frame may be turned at its begin against the end of the last one (elastic frames)."},
          D{"lost_overlap",
            &S::lost_overlap,
            Unit::none,
            {0, 1},
            Tier::advanced,
            "Share of registered points that must agree with the map, or the frame counts as failed."},
          I{"lost_frames",
            &S::lost_frames,
            Unit::none,
            {1, 1000},
            Tier::advanced,
            "Failed frames in a row after which the track is lost and the map ends."},
          D{"least_observability",
            &S::least_observability,
            Unit::none,
            {0, 1000},
            Tier::expert,
            "Least information about the weakest motion of a frame, over what the noise of normals alone would give; "
            "with less the motion is open and the frame counts as failed."},
          D{"speed_max",
            &S::speed_max_m_s,
            Unit::metre_per_second,
            {0.1, 60},
            Tier::advanced,
            "A frame that would be faster counts as failed."},

          D{"loop_radius",
            &S::loop_radius_m,
            Unit::metre,
            {0.5, 100},
            Tier::advanced,
            "Key frames nearer than this are tried as a revisit."},
          D{"loop_path",
            &S::loop_path_m,
            Unit::metre,
            {1, 1000},
            Tier::advanced,
            "Least way walked between the two key frames of a revisit."},
          D{"loop_overlap",
            &S::loop_overlap,
            Unit::none,
            {0, 1},
            Tier::expert,
            "Share of points that must agree for a revisit to be accepted."},
          D{"loop_drift",
            &S::loop_drift,
            Unit::none,
            {0, 1},
            Tier::expert,
            "Share of the way between two key frames by which a revisit found by appearance may correct it, and 3 m."},
          I{"context_rings", &S::context_rings, Unit::none, {2, 200}, Tier::expert, "Rings of a scan context."},
          I{"context_sectors", &S::context_sectors, Unit::none, {4, 720}, Tier::expert, "Sectors of a scan context."},
          D{"context_range", &S::context_range_m, Unit::metre, {2, 200}, Tier::advanced, "Range of a scan context."},
          D{"context_tau",
            &S::context_tau,
            Unit::none,
            {0, 1},
            Tier::advanced,
            "Largest distance of two scan contexts that are tried as a revisit."},
          I{"context_candidates",
            &S::context_candidates,
            Unit::none,
            {1, 1000},
            Tier::expert,
            "Nearest ring keys whose contexts are compared."},

          Option<S, bool>{"dense_map", &S::dense_map, Tier::advanced,
                          "Make the map; otherwise only the trajectory comes out, and the cloud is empty."},
          D{"map_range_min",
            &S::map_range_min_m,
            Unit::metre,
            {0, 50},
            Tier::advanced,
            "Nearer returns stay out of the map."},
          D{"map_range_max",
            &S::map_range_max_m,
            Unit::metre,
            {1, 300},
            Tier::basic,
            "Farther returns stay out of the map."},
          D{"map_voxel",
            &S::map_voxel_m,
            Unit::metre,
            {0.002, 1},
            Tier::basic,
            "The map is thinned on this grid, each pass of the walk on its own."},
          I{"map_points_per_voxel",
            &S::map_points_per_voxel,
            Unit::none,
            {1, 100},
            Tier::advanced,
            "Points that each pass may leave in a voxel of the map."},
          D{"map_max_points",
            &S::map_max_points_million,
            Unit::none,
            {0.01, 2000},
            Tier::advanced,
            "Most points of the map in millions; beyond it the map is thinned at random, evenly."},
          D{"pass_radius",
            &S::pass_radius_m,
            Unit::metre,
            {0.5, 100},
            Tier::advanced,
            "A new pass begins where the path comes this near to an earlier part of the pass after a way of three "
            "times as much."},
          D{"trajectory_rate",
            &S::trajectory_rate_hz,
            Unit::hertz,
            {1, 1000},
            Tier::advanced,
            "Poses per second of the trajectory that is put out."},
      },
      check);
  return table;
}

SlamOptions resolved(const SlamOptions& options) {
  const auto& table = option_table(&options);
  for (const auto& preset : presets()) {
    if (preset.name != options.preset) continue;
    SlamOptions out = options;
    for (const auto& [name, value] : preset.values) {
      const auto& spec = table.at(name);
      if (spec.get(&out) == spec.default_value) spec.assign(&out, spec.checked(value));
    }
    return out;
  }
  throw bad_input("preset '" + options.preset + "'", table.at("preset").needed());
}

}  // namespace bole
