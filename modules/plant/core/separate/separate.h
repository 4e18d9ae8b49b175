// A coloured cloud of a potted plant divided into plant, pot, soil, mat and floaters.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "cloud/point_cloud.h"
#include "plant/core/separate/plant_scene.h"

namespace bole::plant {

// automatic: z where the axes come from a board, else out of the largest plane, else z.
enum class UpChoice { automatic, x, y, z, minus_y };
constexpr std::array<std::string_view, 5> choice_names(UpChoice) { return {"auto", "x", "y", "z", "-y"}; }

// automatic: known where a board, given poses or a depth camera fixed it.
enum class ScaleChoice { automatic, metres, unknown };
constexpr std::array<std::string_view, 3> choice_names(ScaleChoice) { return {"auto", "metres", "unknown"}; }

struct SeparateOptions {
  UpChoice up = UpChoice::automatic;
  ScaleChoice scale = ScaleChoice::automatic;
  std::string box;   // min_x min_y min_z max_x max_y max_z; empty: everything
  std::string base;  // x y z of the foot of the stem; empty: found
  double max_gap = 0.015;
  double tolerance = 0.0025;
  bool drop_floaters = false;
};
const OptionTable& option_table(const SeparateOptions*);

struct Separated {
  PointCloud points;  // with the column `part` (int32, values of Part) and the facts of the scene
  PlantScene scene;
  Report report;
};

// `points`: metres or any unit; red, green, blue are used where present. `poses`: T_world_camera of the views that the
// cloud was made from, or null. `depth_surface`: the fused depth images in the same axes, or null; measured depth shows
// the soil more truly than a field does, which is not sharp where all is dark. Throws Error{bad_input} for a cloud with
// fewer than 100 points, a box or base that are no numbers, and where no plant stands above the soil.
Separated separate(const PointCloud& points, const Trajectory* poses, bool depth_camera, const SeparateOptions& options,
                   const Run& run, const PointCloud* depth_surface = nullptr);

}  // namespace bole::plant
