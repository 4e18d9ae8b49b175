// The choices that the options of slam.run offer, and the words for them in documents and forms.
#pragma once

#include <array>
#include <string_view>

namespace bole::slam {

// Those that end in `paper` do what a paper prints, and no more: docs/dev/slam-papers.md.
enum class Preset {
  loam,
  forest,
  lego_loam,
  orchard,
  best,
  inertial,
  loam_paper,
  forest_paper,
  lego_loam_orchard_paper
};
constexpr std::array<std::string_view, 9> choice_names(Preset) {
  return {"loam",       "forest",       "lego_loam",
          "orchard",    "best",         "inertial",
          "loam_paper", "forest_paper", "lego_loam_orchard_paper"};
}

// Whether the inertial unit of the recording is used: never, where there is one, or always.
enum class InertialUse { off, automatic, required };
constexpr std::array<std::string_view, 3> choice_names(InertialUse) { return {"off", "auto", "required"}; }

enum class FeatureKind {
  curvature,  // edges and planes by curvature along the scan line (LOAM)
  connected,  // the same, curvature only among neighbours without a step in range between them
  ground,     // as `curvature`, planes on the ground and edges on objects that stand on it (LeGO-LOAM)
  sampled     // all points, thinned on a grid
};
constexpr std::array<std::string_view, 4> choice_names(FeatureKind) {
  return {"curvature", "connected", "ground", "sampled"};
}

// On which side of a step in range edges are rejected.
enum class Occlusion { none, far_side, both_sides };
constexpr std::array<std::string_view, 3> choice_names(Occlusion) { return {"none", "far_side", "both_sides"}; }

// The motion before registration.
enum class FirstGuess {
  velocity,       // constant velocity
  last_frame,     // the frame is matched as a whole against the surfaces of the last frame
  matched_motion  // the motion within the frame is matched point by point against the last frame (SPEC A3)
};
constexpr std::array<std::string_view, 3> choice_names(FirstGuess) {
  return {"velocity", "last_frame", "matched_motion"};
}

enum class Deskew {
  none,
  once,    // with the first guess
  twice,   // again after a first registration
  elastic  // begin and end pose are estimated together
};
constexpr std::array<std::string_view, 4> choice_names(Deskew) { return {"none", "once", "twice", "elastic"}; }

// Which keyframes make the local map: the nearest to the sensor, or the last ones.
enum class LocalMapKind { nearest, last };
constexpr std::array<std::string_view, 2> choice_names(LocalMapKind) { return {"nearest", "last"}; }

// Where loop closures are looked for.
enum class LoopSource { none, odometry, context, both };
constexpr std::array<std::string_view, 4> choice_names(LoopSource) { return {"none", "odometry", "context", "both"}; }
constexpr bool uses_odometry(LoopSource source) { return source == LoopSource::odometry || source == LoopSource::both; }
constexpr bool uses_context(LoopSource source) { return source == LoopSource::context || source == LoopSource::both; }

// How a place with similar surroundings is chosen: see find_loop_candidates().
enum class ContextSearchKind { single, placed, sequence };
constexpr std::array<std::string_view, 3> choice_names(ContextSearchKind) { return {"single", "placed", "sequence"}; }

// Over which sectors the distance of two scan contexts is the mean: those that both have, or all (SPEC D, equation 4).
enum class ContextDistance { shared_sectors, all_sectors };
constexpr std::array<std::string_view, 2> choice_names(ContextDistance) { return {"shared_sectors", "all_sectors"}; }

// What makes a candidate a loop: that the points agree there and the odometry allows it, or that the scan contexts are
// alike and the closest points near (SPEC D).
enum class LoopAcceptance { overlap, distance };
constexpr std::array<std::string_view, 2> choice_names(LoopAcceptance) { return {"overlap", "distance"}; }

enum class LoopRegistrationKind { features, icp, ndt_icp };
constexpr std::array<std::string_view, 3> choice_names(LoopRegistrationKind) { return {"features", "icp", "ndt_icp"}; }

// What the weight of a match is made from: see registration.h and priors.h. The last two have no robust kernel.
enum class Weights {
  thickness,
  priors,
  equal,      // A = I: every match counts the same (LOAM as SPEC A tells it)
  conditions  // (A Q A^T)^-1 with the covariance of every point of a condition (SPEC A7)
};
constexpr std::array<std::string_view, 4> choice_names(Weights) {
  return {"thickness", "priors", "equal", "conditions"};
}
constexpr bool uses_priors(Weights weights) { return weights == Weights::priors || weights == Weights::conditions; }
constexpr bool is_plain(Weights weights) { return weights == Weights::equal || weights == Weights::conditions; }

enum class Solve {
  joint,
  two_step,       // in every registration
  two_step_guess  // against the last frame only, as in LeGO-LOAM
};
constexpr std::array<std::string_view, 3> choice_names(Solve) { return {"joint", "two_step", "two_step_guess"}; }

// Which search proposed a loop; `hand`: a person.
enum class FoundBy { odometry, context, hand };
constexpr std::array<std::string_view, 3> choice_names(FoundBy) { return {"odometry", "context", "hand"}; }

}  // namespace bole::slam
