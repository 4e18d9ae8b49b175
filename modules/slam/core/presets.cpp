// The table of presets: SPEC A calls the first two "LOAM" and "improved LOAM", SPEC D compares the next two, the next
// two are ours: `inertial` is `best` and wants an inertial unit. SPEC D builds its loops on the features of LeGO-LOAM.
// `orchard` takes all points instead: there are few objects and lines among leaves, and the trajectory slips along the
// rows. The last three keep to the papers: docs/dev/slam-papers.md has each element with the words of the paper.
#include "slam/core/options.h"

namespace bole::slam {
namespace {

// One value for each preset, in the order of Preset.
template <class T>
using PerPreset = std::array<T, choice_names(Preset{}).size()>;

constexpr PresetFields<PerPreset> preset_values() {
  using enum FeatureKind;
  using enum Occlusion;
  using enum FirstGuess;
  using enum Weights;
  using enum Solve;
  using L = LocalMapKind;
  using S = LoopSource;
  using C = ContextSearchKind;
  using R = LoopRegistrationKind;
  using D = Deskew;
  using U = InertialUse;
  using A = LoopAcceptance;
  constexpr auto shared = ContextDistance::shared_sectors, all = ContextDistance::all_sectors;
  // clang-format off
  return {
      //                      loam         forest       lego_loam    orchard      best        inertial      loam_paper      forest_paper    lego_loam_orchard_paper
      .features            = {curvature,   connected,   ground,      sampled,     sampled,    sampled,      curvature,      curvature,      ground},
      .occlusion           = {far_side,    both_sides,  far_side,    far_side,    both_sides, both_sides,   far_side,       both_sides,     far_side},
      .occlusion_step      = {0.3,         0.3,         0.3,         0.3,         0.3,        0.3,          0.3,            0.3,            0.3},
      .query_spacing       = {0.4,         0.4,         0.4,         0.6,         0.6,        0.6,          0.4,            0.4,            0.4},
      .map_spacing         = {0.2,         0.2,         0.2,         0.2,         0.1,        0.1,          0.2,            0.2,            0.2},
      .first_guess         = {velocity,    last_frame,  velocity,    velocity,    velocity,   velocity,     matched_motion, matched_motion, matched_motion},
      .deskew              = {D::once,     D::twice,    D::once,     D::elastic,  D::elastic, D::elastic,   D::once,        D::twice,       D::once},
      // After a sudden turn the prediction is off by degrees, and begin and end pose need more iterations.
      .iterations          = {12,          12,          12,          30,          30,         30,           25,             25,             25},
      .neighbour_keyframes = {60,          60,          60,          60,          400,        400,          60,             60,             60},
      .local_map           = {L::nearest,  L::nearest,  L::last,     L::last,     L::nearest, L::nearest,   L::nearest,     L::nearest,     L::last},
      .keyframe_distance   = {0.3,         0.3,         0.3,         0.3,         0.3,        0.3,          0.3,            0.3,            0.3},
      .keyframe_angle_deg  = {10,          10,          10,          10,          10,         10,           10,             10,             10},
      .loops               = {S::none,     S::both,     S::odometry, S::context,  S::odometry,S::odometry,  S::none,        S::both,        S::context},
      .context_search      = {C::placed,   C::placed,   C::placed,   C::sequence, C::placed,  C::placed,    C::single,      C::single,      C::single},
      .context_distance    = {shared,      shared,      shared,      shared,      shared,     shared,       all,            all,            all},
      .loop_registration   = {R::features, R::features, R::icp,      R::ndt_icp,  R::features,R::features,  R::features,    R::features,    R::ndt_icp},
      .loop_stretch        = {8,           8,           8,           8,           8,          8,            8,              8,              0},
      .loop_acceptance     = {A::overlap,  A::overlap,  A::overlap,  A::overlap,  A::overlap, A::overlap,   A::overlap,     A::overlap,     A::distance},
      // Vines agree with those of the next row to 0.67 to 0.81, and with themselves to 0.94 and more.
      .loop_overlap        = {0.6,         0.6,         0.6,         0.85,        0.6,        0.6,          0.6,            0.6,            0.6},
      .weights             = {thickness,   priors,      thickness,   thickness,   thickness,  thickness,    equal,          conditions,     equal},
      .solve               = {joint,       joint,       two_step,    joint,       joint,      joint,        joint,          joint,          two_step_guess},
      .refine_iterations   = {0,           0,           0,           0,           3,          3,            0,              0,              0},
      .inertial            = {U::off,      U::off,      U::off,      U::off,      U::automatic,U::required,  U::off,         U::off,         U::off},
  };
  // clang-format on
}

// Calls `f` with the same field of each of the structs.
template <class F, class... Fields>
void for_each_field(F f, Fields&... in) {
  f(in.features...);
  f(in.occlusion...);
  f(in.occlusion_step...);
  f(in.query_spacing...);
  f(in.map_spacing...);
  f(in.first_guess...);
  f(in.deskew...);
  f(in.iterations...);
  f(in.neighbour_keyframes...);
  f(in.local_map...);
  f(in.keyframe_distance...);
  f(in.keyframe_angle_deg...);
  f(in.loops...);
  f(in.context_search...);
  f(in.context_distance...);
  f(in.loop_registration...);
  f(in.loop_stretch...);
  f(in.loop_acceptance...);
  f(in.loop_overlap...);
  f(in.weights...);
  f(in.solve...);
  f(in.refine_iterations...);
  f(in.inertial...);
}

}  // namespace

SlamOptions filled_in(const SlamOptions& options) {
  static constexpr auto presets = preset_values();
  SlamOptions out = options;
  const auto column = static_cast<std::size_t>(options.preset);
  for_each_field([&](auto& field, const auto& values) { field = field.value_or(values[column]); }, out, presets);
  return out;
}

SlamSettings resolved(const SlamOptions& options) {
  const SlamOptions filled = filled_in(options);
  SlamSettings out{filled, {}};
  for_each_field([](auto& field, const auto& value) { field = *value; }, out, filled);
  return out;
}

}  // namespace bole::slam
