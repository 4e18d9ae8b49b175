#include "sim/core/field/field_recipe.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::sim {

template <class V>
void each_field(FieldPlants& p, V&& visit) {
  visit("kind", p.kind, 0, 0);
  visit("at", p.at, 0, 0);
  visit("rows", p.rows, 1, 200);
  visit("plants_per_row", p.plants_per_row, 1, 500);
  visit("plant_spacing_m", p.plant_spacing_m, 0.05, 50);
  visit("row_spacing_m", p.row_spacing_m, 0.05, 50);
  visit("angle_deg", p.angle_deg, -180, 180);
  visit("position_sd_m", p.position_sd_m, 0, 1);
  visit("missing_share", p.missing_share, 0, 0.9);
  visit("height_m", p.height_m, 0.2, 40);
  visit("diameter_min_mm", p.diameter_min_mm, 5, 2000);
  visit("diameter_max_mm", p.diameter_max_mm, 5, 2000);
  visit("lean_sd_deg", p.lean_sd_deg, 0, 15);
  visit("leaves", p.leaves, 0, 500);
}

template <class V>
void each_field(FieldGround& g, V&& visit) {
  visit("slope_deg", g.slope_deg, 0, 30);
  visit("undulation_m", g.undulation_m, 0, 2);
  visit("weeds_per_m2", g.weeds_per_m2, 0, 20);
}

template <class V>
void each_field(FieldSensor& s, V&& visit) {
  visit("x_m", s.x_m, -1000, 1000);
  visit("y_m", s.y_m, -1000, 1000);
  visit("heading_deg", s.heading_deg, -360, 360);
  visit("height_m", s.height_m, 0.1, 5);
}

template <class V>
void each_field(FieldRecipe& r, V&& visit) {
  visit("name", r.name, 0, 0);
  visit("title", r.title, 0, 0);
  visit("plants", r.plants, 0, 0);
  visit("ground", r.ground, 0, 0);
  visit("sensor", r.sensor, 0, 0);
}

FieldRecipe parse_field(const nlohmann::json& json) {
  auto recipe = recipe_from_json<FieldRecipe>(json);
  if (recipe.plants.diameter_min_mm > recipe.plants.diameter_max_mm)
    throw bad_input("recipe field 'plants.diameter_min_mm' is above diameter_max_mm", "the smaller one first");
  return recipe;
}

FieldRecipe read_field(const std::string& name_or_path) {
  return parse_recipe_file(find_recipe("fields", name_or_path), parse_field);
}

std::vector<std::string> field_names() { return recipe_names("fields"); }

}  // namespace bole::sim
