// A seedling before an RGB-D camera: pictures, depth and the truth, as a folder.
#pragma once

#include <filesystem>

#include "base/report.h"
#include "base/run.h"
#include "sim/core/seedling/seedling_options.h"

namespace bole::sim {

// Writes into `folder`:
//   color/NNNNNN.png, depth/NNNNNN.png (16 bit, 0: none), camera.json, mat.json, poses.tum
//   truth/traits.csv, leaves.csv, internodes.csv, stem.csv, branches.csv, poses.tum (T_world_camera), mesh.ply
//   recipe.json (the recipe with every default filled in, all options)
// World axes are those of the mat: origin at the lower left corner of its pattern, z up, metres. View i has the time
// i / 30 s. The same options give the same bytes at any thread count. Throws Error{bad_input} for unknown recipes
// and for a folder that already holds pictures, Error{failed} when a file cannot be written and Error{cancelled}.
Report simulate_seedling(const SeedlingSimulationOptions& options, const std::filesystem::path& folder, const Run& run);

}  // namespace bole::sim
