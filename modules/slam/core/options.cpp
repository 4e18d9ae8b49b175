#include "slam/core/options.h"

#include <set>

#include "slam/core/option_groups.h"
#include "slam/core/presets.h"

namespace bole::slam {
namespace {

using S = SlamOptions;
using D = Option<S, double>;
using I = Option<S, int>;
using T = Option<S, std::string>;

SlamOptionEntries general_options() {
  return {
      T{"preset", &S::preset, TextKind::choice, preset_names(), Tier::basic,
        "Which system: loam (baseline), forest (improved LOAM for forest plots), lego_loam (ground-aware baseline), "
        "orchard (for rows and leaves: all points, loops by Scan Context and NDT-ICP), best (elastic frames and a "
        "final adjustment of the whole path)."},
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
  };
}

SlamOptionEntries options_of_presets() {
  return {
      T{"features",
        &S::features,
        TextKind::choice,
        {"preset", "curvature", "connected", "ground", "sampled"},
        Tier::advanced,
        "Points that are registered: edges and planes by curvature along the scan line (LOAM), by curvature among "
        "neighbours without a step in range between them, the first with planes from the ground and edges from "
        "things that stand on it (LeGO-LOAM), or all points thinned on a grid."},
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
      T{"local_map",
        &S::local_map,
        TextKind::choice,
        {"preset", "nearest", "last"},
        Tier::advanced,
        "The key frames of the local map: those nearest to the sensor, or the last ones (LeGO-LOAM with loops), "
        "which leaves revisits to the loops."},
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
      T{"context_search",
        &S::context_search,
        TextKind::choice,
        {"preset", "single", "placed", "sequence"},
        Tier::advanced,
        "How a place that looks alike is chosen: the one that does most, its turn being all that is known of the pose "
        "(SPEC D); of the three that do most the one on whose occupancy the key frame lies best; or the same of places "
        "that the odometry can have drifted to and that look alike along the last metres of the way."},
      T{"loop_registration",
        &S::loop_registration,
        TextKind::choice,
        {"preset", "features", "icp", "ndt_icp"},
        Tier::advanced,
        "How the relative pose of a revisit is found: by edges and planes, by closest points, or by normal "
        "distributions and then closest points."},
      D{"loop_overlap",
        &S::loop_overlap,
        Unit::none,
        {0, 1},
        Tier::advanced,
        "Share of points that must agree for a revisit to be accepted; 0: as the preset says."},
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
      Unless{"features", {"sampled"}, {"occlusion", "occlusion_step"}},
      Unless{"loops", {"none"}, {"loop_registration", "loop_overlap"}},
      OnlyIf{"loops", {"preset", "context", "both"}, {"context_search"}},
  };
}

// Poses that are given leave nothing to estimate; key frames are counted along them all the same.
OnlyIf only_if_estimated(const SlamOptionEntries& entries) {
  OnlyIf condition{"trajectory", {""}, {}};
  for (const auto& entry : entries)
    if (const auto& name = entry.spec.name;
        !std::set<std::string>{"", "preset", "trajectory", "keyframe_distance"}.contains(name))
      condition.of.push_back(name);
  return condition;
}

void check(const SlamOptions& o) {
  if (o.trajectory.empty() && o.range_min_m >= o.range_max_m)
    throw bad_input("range_min is " + number_text(o.range_min_m) + " m",
                    "less than range_max, " + number_text(o.range_max_m) + " m");
  if (o.dense_map && o.map_range_min_m >= o.map_range_max_m)
    throw bad_input("map_range_min is " + number_text(o.map_range_min_m) + " m",
                    "less than map_range_max, " + number_text(o.map_range_max_m) + " m");
  if (o.deskew == "elastic" && o.solve == "two_step")
    throw bad_input("solve is two_step with deskew elastic", "joint with elastic frames",
                    "Set solve to joint, or deskew to once");
}

}  // namespace

const OptionTable& option_table(const SlamOptions*) {
  static const OptionTable table = [] {
    SlamOptionEntries entries;
    const auto add = [&](const SlamOptionEntries& group) { entries.insert(entries.end(), group.begin(), group.end()); };
    add(general_options()), add(options_of_presets()), add(registration_options()), add(loop_options());
    entries.push_back(only_if_estimated(entries));
    add(map_options());
    return make_option_table<SlamOptions>(std::move(entries), check);
  }();
  return table;
}

}  // namespace bole::slam
