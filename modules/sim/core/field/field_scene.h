// A planted field: where its plants stand, and the triangles that rays meet.
#pragma once

#include <vector>

#include "cloud/table.h"
#include "sim/core/field/field_recipe.h"
#include "sim/core/plot/terrain.h"
#include "sim/core/scene/scene_model.h"

namespace bole::sim {

struct FieldPlant {
  int row = 0, number = 0;  // from 1
  bool missing = false;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();    // of the axis, half way up (at 0.5 m for what is taller)
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();  // horizontal shift of the axis per metre of height
  double diameter_m = 0, height_m = 0;
};

struct Field {
  FieldRecipe recipe;
  Terrain terrain;
  std::vector<FieldPlant> plants;
};

Field plant_field(const FieldRecipe& recipe, std::uint64_t seed);

SceneModel build_field_scene(const Field& field, std::uint64_t seed);

// row_id, number, x_m, y_m, state (present, missing), diameter_mm, tree_id.
Table field_plant_table(const Field& field);

// The true rows by least squares through the plants that stand: row_id, angle_deg (to east, -90 to 90], x0_m, y0_m,
// x1_m, y1_m, plants.
Table field_row_table(const Field& field);

}  // namespace bole::sim
