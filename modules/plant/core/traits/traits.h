// The traits of a plant with their 95 % intervals.
#pragma once

#include <optional>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "plant/core/separate/plant_scene.h"

namespace bole::plant {

// How the diameter of the stem is measured.
enum class StemMethod { automatic, contours, cloud };
constexpr std::array<std::string_view, 3> choice_names(StemMethod) { return {"auto", "contours", "cloud"}; }

// How codes of the pictures become light.
enum class PictureLight { automatic, srgb, linear };
constexpr std::array<std::string_view, 3> choice_names(PictureLight) { return {"auto", "srgb", "linear"}; }

struct TraitOptions {
  double stem_height = 0.030;
  StemMethod stem = StemMethod::automatic;
  double stretch = 0.024;
  int max_views = 120;
  PictureLight light = PictureLight::automatic;
  double scale_sd = 0.1;  // percent
  double surface_sd = 0.0005;
  double tip_reach = 0.008;
  std::string plant_id;
};
const OptionTable& option_table(const TraitOptions*);

struct TraitInputs {
  const PointCloud* points = nullptr;  // of plant.separate
  const ViewSource* views = nullptr;   // null: no pictures
  const Trajectory* poses = nullptr;   // T_world_camera, in the axes of the points
};

struct Traits {
  Table traits;  // one row
  Table stem;    // sections of the stem
  Table leaves;
  Table internodes;
  Table branches;
  Table contours;  // measured edges: view, name, height_mm, x/y of both edges in pixels, diameter_mm, weight
  Report report;
};

// Throws Error{bad_input} for points without the column `part` or the facts of plant.separate, and without a plant.
Traits measure_traits(const TraitInputs& inputs, const TraitOptions& options, const Run& run);

}  // namespace bole::plant
