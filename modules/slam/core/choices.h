// The choices that the options of slam.run offer, and the words for them in documents and forms.
#pragma once

#include <array>
#include <string_view>

namespace bole::slam {

enum class Preset { loam, forest, lego_loam, orchard, best, inertial };
constexpr std::array<std::string_view, 6> choice_names(Preset) {
  return {"loam", "forest", "lego_loam", "orchard", "best", "inertial"};
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

// The motion before registration: constant velocity, or matched against the last frame.
enum class FirstGuess { velocity, last_frame };
constexpr std::array<std::string_view, 2> choice_names(FirstGuess) { return {"velocity", "last_frame"}; }

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

enum class LoopRegistrationKind { features, icp, ndt_icp };
constexpr std::array<std::string_view, 3> choice_names(LoopRegistrationKind) { return {"features", "icp", "ndt_icp"}; }

// What the weight of a match is made from: see registration.h and priors.h.
enum class Weights { thickness, priors };
constexpr std::array<std::string_view, 2> choice_names(Weights) { return {"thickness", "priors"}; }

enum class Solve { joint, two_step };
constexpr std::array<std::string_view, 2> choice_names(Solve) { return {"joint", "two_step"}; }

// Which search proposed a loop.
enum class FoundBy { odometry, context };
constexpr std::array<std::string_view, 2> choice_names(FoundBy) { return {"odometry", "context"}; }

}  // namespace bole::slam
