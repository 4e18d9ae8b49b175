#include "slam/core/option_groups.h"

namespace bole::slam {
namespace {

using S = SlamOptions;
using D = Option<S, double>;
using I = Option<S, int>;
using OpenD = Option<S, std::optional<double>>;
using OpenI = Option<S, std::optional<int>>;
template <class E>
using Open = Option<S, std::optional<E>>;

// The word for an option that is left to the preset.
constexpr std::string_view preset = "preset";

}  // namespace

SlamOptionEntries general_options() {
  return {
      Option<S, Preset>{
          "preset", &S::preset, Tier::basic,
          "SLAM system: loam (baseline), forest (LOAM improved for forest plots), lego_loam (ground-aware "
          "baseline), orchard (plant rows and foliage), best (elastic frames and a final trajectory "
          "adjustment, with the inertial unit where the recording has one), inertial (the same, and only with an "
          "inertial unit), or to the letter of a paper: loam_paper, forest_paper, lego_loam_orchard_paper."},
      Option<S, std::string>{
          "trajectory",
          &S::trajectory,
          TextKind::input_path,
          {},
          Tier::basic,
          "TUM file with sensor poses. The map is made with these poses, and none are estimated; the "
          "times must be on the clock of the scan."},
      D{"min_range",
        &S::min_range,
        Unit::metre,
        {0, 10},
        Tier::advanced,
        "Returns closer than this are ignored (they hit the operator)."},
      D{"max_range",
        &S::max_range,
        Unit::metre,
        {1, 300},
        Tier::advanced,
        "Returns farther than this are not used for registration."},
  };
}

SlamOptionEntries preset_options() {
  return {
      Open<FeatureKind>{"features", &S::features, preset, Tier::advanced,
                        "Points used for registration: edges and planes by curvature (LOAM), the same with curvature "
                        "measured within connected surfaces, planes on the ground and edges on objects (LeGO-LOAM), "
                        "or all points thinned on a grid."},
      Open<Occlusion>{"occlusion", &S::occlusion, preset, Tier::advanced,
                      "Where edges beside a step in range are rejected: nowhere, on the far side (LOAM), or on both "
                      "sides, so that the outline of a trunk is never an edge."},
      OpenD{"occlusion_step",
            &S::occlusion_step,
            Unit::metre,
            {0.01, 5},
            preset,
            Tier::advanced,
            "Difference in range between neighbours of a scan line that counts as an occlusion."},
      OpenD{"query_spacing",
            &S::query_spacing,
            Unit::metre,
            {0.01, 5},
            preset,
            Tier::advanced,
            "Grid that thins the points to be registered. A larger value is faster and less accurate."},
      OpenD{"map_spacing",
            &S::map_spacing,
            Unit::metre,
            {0.01, 5},
            preset,
            Tier::advanced,
            "Grid that thins the points of a keyframe. A larger value is faster and gives a coarser local map."},
      Open<FirstGuess>{
          "first_guess", &S::first_guess, preset, Tier::advanced,
          "Motion before registration: constant velocity, the frame matched as a whole against the last frame, "
          "or the motion within the frame matched point by point against the last frame, half way from constant "
          "velocity."},
      Open<Deskew>{"deskew", &S::deskew, preset, Tier::advanced,
                   "Correction of the motion within a frame: none, once with the first guess, twice (again after a "
                   "first registration), or elastic (begin and end pose are estimated together)."},
      OpenI{"iterations",
            &S::iterations,
            Unit::none,
            {1, 100},
            preset,
            Tier::expert,
            "Maximum number of iterations of a registration."},
      OpenI{"neighbour_keyframes",
            &S::neighbour_keyframes,
            Unit::none,
            {1, 100000},
            preset,
            Tier::advanced,
            "Number of keyframes in the local map."},
      Open<LocalMapKind>{"local_map", &S::local_map, preset, Tier::advanced,
                         "Keyframes in the local map: those nearest to the sensor, or the last ones (LeGO-LOAM), which "
                         "leaves revisits to the loop closures."},
      OpenD{"keyframe_distance",
            &S::keyframe_distance,
            Unit::metre,
            {0.01, 20},
            preset,
            Tier::advanced,
            "Distance travelled after which a new keyframe is made."},
      OpenD{"keyframe_angle",
            &S::keyframe_angle_deg,
            Unit::degree,
            {0.1, 180},
            preset,
            Tier::advanced,
            "Rotation after which a new keyframe is made."},
      Open<LoopSource>{"loops", &S::loops, preset, Tier::advanced,
                       "Where loop closures are looked for: nowhere, where the estimated trajectory comes close to "
                       "itself, where the surroundings look similar (Scan Context), or both."},
      Open<ContextSearchKind>{"context_search", &S::context_search, preset, Tier::advanced,
                              "How the place is chosen by its surroundings: the most similar one (single), the best "
                              "fit of the three most similar (placed), or the same over the last metres travelled and "
                              "within the drift of the odometry (sequence)."},
      Open<ContextDistance>{"context_distance", &S::context_distance, preset, Tier::expert,
                            "Sectors over which the distance of two scan contexts is the mean: those that both have, "
                            "or all of them; a sector that one lacks then counts as different."},
      Open<LoopRegistrationKind>{"loop_registration", &S::loop_registration, preset, Tier::advanced,
                                 "How the relative pose of a loop closure is found: edges and planes, closest points "
                                 "(ICP), or normal distributions (NDT) and then ICP."},
      OpenI{"loop_stretch",
            &S::loop_stretch,
            Unit::none,
            {0, 1000},
            preset,
            Tier::expert,
            "Keyframes on each side of the earlier one that a loop closure is registered against. 0: that one alone."},
      Open<LoopAcceptance>{"loop_acceptance", &S::loop_acceptance, preset, Tier::advanced,
                           "What makes a candidate a loop closure: points that agree at a place that the odometry "
                           "allows (overlap), or similar scan contexts and near closest points (distance)."},
      OpenD{"loop_overlap",
            &S::loop_overlap,
            Unit::none,
            {0, 1},
            preset,
            Tier::advanced,
            "Minimum share of points that agree for a loop closure to be accepted. A larger value rejects more."},
      Open<Weights>{"weights", &S::weights, preset, Tier::advanced,
                    "Weight of a match: from the thickness of the surface and the range noise (thickness), from the "
                    "covariances of the points by sensor and poses (priors), or without a robust kernel the same for "
                    "all (equal) or with the covariance of every single point (conditions)."},
      Open<Solve>{"solve", &S::solve, preset, Tier::advanced,
                  "All six unknowns from all features, or height, roll and pitch from planes and the rest from edges, "
                  "always or only against the last frame (LeGO-LOAM; not with elastic frames)."},
      OpenI{"refine_iterations",
            &S::refine_iterations,
            Unit::none,
            {0, 20},
            preset,
            Tier::advanced,
            "Iterations of the final trajectory adjustment; 0: no adjustment."},
      Open<InertialUse>{"inertial", &S::inertial, preset, Tier::advanced,
                        "Use of the inertial unit: off, auto (where the recording has one and frames are elastic), or "
                        "required."},
      Unless{"features", {"sampled"}, {"occlusion", "occlusion_step"}},
      Unless{"loops", {"none"}, {"loop_registration", "loop_stretch", "loop_acceptance", "loop_overlap"}},
      Unless{"loop_acceptance", {"distance"}, {"loop_overlap"}},
      OnlyIf{"loops", {"preset", "context", "both"}, {"context_search", "context_distance"}},
  };
}

SlamOptionEntries registration_options() {
  return {
      D{"cell",
        &S::cell_size,
        Unit::metre,
        {0.02, 2},
        Tier::expert,
        "Finest cell of the map for registration; each coarser level doubles it."},
      D{"range_sigma",
        &S::range_sigma,
        Unit::metre,
        {0.001, 0.5},
        Tier::expert,
        "Standard deviation of a range. It is added to the thickness of map surfaces."},
      D{"angle_sigma",
        &S::angle_sigma_deg,
        Unit::degree,
        {0.001, 5},
        Tier::expert,
        "Standard deviation of the azimuth and elevation of a return."},
      D{"kernel_sigmas",
        &S::kernel_sigmas,
        Unit::none,
        {0.5, 20},
        Tier::expert,
        "Scale of the robust kernel (Geman-McClure) in standard deviations. A larger value gives outliers more "
        "weight."},
      D{"continuity_sigma",
        &S::continuity_sigma,
        Unit::metre,
        {0.0001, 1},
        Tier::expert,
        "Standard deviation of the distance between the end of a frame and the start of the next frame."},
      D{"continuity_sigma_angle",
        &S::continuity_sigma_deg,
        Unit::degree,
        {0.001, 10},
        Tier::expert,
        "Standard deviation of the rotation between the end of a frame and the start of the next frame."},
      D{"lost_overlap",
        &S::lost_overlap,
        Unit::none,
        {0, 1},
        Tier::advanced,
        "Minimum share of registered points that agree with the map. A frame with less counts as failed."},
      I{"lost_frames",
        &S::lost_frames,
        Unit::none,
        {1, 1000},
        Tier::advanced,
        "Number of consecutive failed frames after which the track is lost. The map ends there."},
      D{"min_observability",
        &S::min_observability,
        Unit::none,
        {0, 1000},
        Tier::expert,
        "Minimum information about the weakest motion of a frame, as a multiple of what noise alone would give. A "
        "frame with less counts as failed; with weights equal or conditions one with less than 85 %, and the others "
        "are reported."},
      D{"max_speed",
        &S::max_speed,
        Unit::metre_per_second,
        {0.1, 60},
        Tier::advanced,
        "Maximum speed of the sensor. A faster frame counts as failed."},
      OnlyIf{"weights", {"preset", "priors", "conditions"}, {"angle_sigma"}},
      OnlyIf{"deskew", {"preset", "elastic"}, {"continuity_sigma", "continuity_sigma_angle"}},
  };
}

SlamOptionEntries inertial_options() {
  return {
      D{"inertial_trust",
        &S::inertial_trust,
        Unit::none,
        {0.001, 1},
        Tier::expert,
        "Share of the points of a frame that count as independent against the inertial unit. A smaller value trusts "
        "the unit more."},
      D{"inertial_bridge",
        &S::inertial_bridge,
        Unit::metre,
        {0.01, 10},
        Tier::advanced,
        "Standard deviation of the place up to which the inertial unit alone leads over open motions and frames "
        "without "
        "returns. Beyond it a frame counts as failed."},
      OpenD{"inertial_offset",
            &S::inertial_offset,
            Unit::second,
            {-1, 1},
            "auto",
            Tier::expert,
            "Time by which the clock of the inertial unit is ahead of that of the scanner. auto: estimated where the "
            "mount of the unit is not known, else 0."},
      Unless{"inertial", {"off"}, {"inertial_trust", "inertial_bridge", "inertial_offset"}},
  };
}

SlamOptionEntries loop_options() {
  return {
      D{"loop_radius",
        &S::loop_radius,
        Unit::metre,
        {0.5, 100},
        Tier::advanced,
        "Maximum distance between the two keyframes of a loop closure, before and after registration."},
      D{"loop_path",
        &S::loop_path,
        Unit::metre,
        {1, 1000},
        Tier::advanced,
        "Minimum distance travelled between the two keyframes of a loop closure."},
      D{"loop_drift",
        &S::loop_drift,
        Unit::none,
        {0, 1},
        Tier::expert,
        "Expected drift as a share of the distance travelled. A loop closure found by its surroundings may correct the "
        "trajectory by this much and 3 m."},
      D{"loop_fitness",
        &S::loop_fitness,
        Unit::metre,
        {0.01, 10},
        Tier::expert,
        "Maximum distance between closest points (root mean square) of a loop closure that is accepted by distance."},
      I{"context_rings", &S::context_rings, Unit::none, {2, 200}, Tier::expert, "Number of rings of a scan context."},
      I{"context_sectors",
        &S::context_sectors,
        Unit::none,
        {4, 720},
        Tier::expert,
        "Number of sectors of a scan context."},
      D{"context_range", &S::context_range, Unit::metre, {2, 200}, Tier::advanced, "Radius of a scan context."},
      D{"context_tau",
        &S::context_tau,
        Unit::none,
        {0, 1},
        Tier::advanced,
        "Maximum distance between two scan contexts to be tried as a loop closure. A larger value tries more."},
      I{"context_candidates",
        &S::context_candidates,
        Unit::none,
        {1, 1000},
        Tier::expert,
        "Number of nearest ring keys whose scan contexts are compared."},
      Unless{"loops", {"none"}, {"loop_radius", "loop_path", "loop_fitness"}},
      OnlyIf{"loop_acceptance", {"preset", "distance"}, {"loop_fitness"}},
      OnlyIf{"loops",
             {"preset", "context", "both"},
             {"loop_drift", "context_rings", "context_sectors", "context_range", "context_tau", "context_candidates"}},
  };
}

SlamOptionEntries map_options() {
  return {
      Option<S, bool>{"dense_map", &S::dense_map, Tier::advanced,
                      "Make the map. Without it only the trajectory is output, and the cloud is empty."},
      D{"map_min_range",
        &S::map_min_range,
        Unit::metre,
        {0, 50},
        Tier::advanced,
        "Returns closer than this are left out of the map."},
      D{"map_max_range",
        &S::map_max_range,
        Unit::metre,
        {1, 300},
        Tier::basic,
        "Returns farther than this are left out of the map."},
      D{"map_voxel",
        &S::map_voxel,
        Unit::metre,
        {0.002, 1},
        Tier::basic,
        "Grid that thins the map, separately for each pass. A larger value gives a smaller map."},
      I{"map_points_per_voxel",
        &S::map_points_per_voxel,
        Unit::none,
        {1, 100},
        Tier::advanced,
        "Maximum number of points of each pass in a voxel of the map."},
      D{"map_max_points",
        &S::map_max_points_million,
        Unit::none,
        {0.01, 2000},
        Tier::advanced,
        "Maximum number of points in the map, in millions. A larger map is thinned evenly at random."},
      D{"pass_radius",
        &S::pass_radius,
        Unit::metre,
        {0.5, 100},
        Tier::advanced,
        "A new pass begins where the trajectory comes this close to an earlier part of the same pass, after at least "
        "three times this distance travelled."},
      D{"trajectory_rate",
        &S::trajectory_rate,
        Unit::hertz,
        {1, 1000},
        Tier::advanced,
        "Poses per second in the output trajectory."},
      OnlyIf{"dense_map",
             {"true"},
             {"map_min_range", "map_max_range", "map_voxel", "map_points_per_voxel", "map_max_points", "pass_radius"}},
  };
}

}  // namespace bole::slam
