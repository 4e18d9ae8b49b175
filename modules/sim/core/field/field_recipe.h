// What a planted field and the robot in it are made of: read from resources/fields/*.json.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/plot/recipe_fields.h"

namespace bole::sim {

// tube: with leaves taped on; tree: clear bole; vine: posts and a wall of leaves; apple: branches to all sides.
enum class PlantKind { tube, tree, vine, apple };
constexpr std::array<std::string_view, 4> choice_names(PlantKind) { return {"tube", "tree", "vine", "apple"}; }

// Plants stand at `at` (rows of positions, metres, x east, y north), or are planted in even rows about the origin.
struct FieldPlants {
  PlantKind kind = PlantKind::tube;
  PlantPositions at;
  int rows = 2, plants_per_row = 5;
  double plant_spacing_m = 2, row_spacing_m = 3, angle_deg = 0, position_sd_m = 0.05, missing_share = 0;
  double diameter_min_mm = 25, diameter_max_mm = 50, height_m = 1, lean_sd_deg = 0.5;
  int leaves = 6;  // per plant; for vine and apple: clumps of leaves
};

struct FieldGround {
  double slope_deg = 0, undulation_m = 0.02, weeds_per_m2 = 0;  // falls to a direction drawn by the seed
};

struct FieldSensor {
  double x_m = 0, y_m = 0, heading_deg = 0, height_m = 0.45;  // heading: of the view, east towards north
};

struct FieldRecipe {
  std::string name = "unnamed", title;
  FieldPlants plants;
  FieldGround ground;
  FieldSensor sensor;
};

// Throws Error{bad_input} that names the field of the recipe, its value and what was needed; unknown ones are errors.
FieldRecipe parse_field(const nlohmann::json& json);

// `name_or_path`: a name in resources/fields ("tubes1") or the path of a recipe.
FieldRecipe read_field(const std::string& name_or_path);

// Names in resources/fields, sorted.
std::vector<std::string> field_names();

}  // namespace bole::sim
