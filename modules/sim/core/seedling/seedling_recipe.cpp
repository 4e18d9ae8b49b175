#include "sim/core/seedling/seedling_recipe.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::sim {

template <class R, class V>
void each_field(R& s, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SeedlingStem> {
  visit("height_m", s.height_m, 0.05, 1.5);
  visit("diameter_mm", s.diameter_mm, 1, 30);
  visit("tip_share", s.tip_share, 0.1, 1);
  visit("lean_deg", s.lean_deg, 0, 30);
  visit("bow_share", s.bow_share, 0, 0.3);
  visit("zigzag_deg", s.zigzag_deg, 0, 20);
}

template <class R, class V>
void each_field(R& b, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SeedlingBranches> {
  visit("count", b.count, 0, 20);
  visit("from_share", b.from_share, 0.05, 1);
  visit("to_share", b.to_share, 0.05, 1);
  visit("angle_deg", b.angle_deg, 5, 90);
  visit("length_share", b.length_share, 0.02, 1);
  visit("diameter_share", b.diameter_share, 0.1, 1);
  visit("rise_deg", b.rise_deg, -45, 90);
}

template <class R, class V>
void each_field(R& l, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SeedlingLeaves> {
  visit("spacing_mm", l.spacing_mm, 3, 1000);
  visit("first_share", l.first_share, 0, 1);
  visit("divergence_deg", l.divergence_deg, 0, 360);
  visit("length_mm", l.length_mm, 5, 300);
  visit("width_share", l.width_share, 0.05, 1.5);
  visit("petiole_mm", l.petiole_mm, 1, 100);
  visit("wing_mm", l.wing_mm, 0, 40);
  visit("angle_deg", l.angle_deg, 5, 120);
  visit("droop_deg", l.droop_deg, -60, 120);
  visit("cup", l.cup, -0.6, 0.6);
  visit("fold_deg", l.fold_deg, 0, 60);
  visit("wave_share", l.wave_share, 0, 0.3);
  visit("thickness_mm", l.thickness_mm, 0.1, 2);
  visit("yellow", l.yellow, 0, 1);
}

template <class R, class V>
void each_field(R& p, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SeedlingPot> {
  visit("top_mm", p.top_mm, 30, 220);
  visit("bottom_share", p.bottom_share, 0.4, 1);
  visit("height_mm", p.height_mm, 20, 250);
  visit("soil_below_mm", p.soil_below_mm, 2, 100);
  visit("relief_mm", p.relief_mm, 0, 5);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SeedlingRecipe> {
  visit("name", r.name, 0, 0);
  visit("title", r.title, 0, 0);
  visit("stem", r.stem, 0, 0);
  visit("branches", r.branches, 0, 0);
  visit("leaves", r.leaves, 0, 0);
  visit("pot", r.pot, 0, 0);
}

SeedlingRecipe parse_seedling(const nlohmann::json& json) {
  auto recipe = recipe_from_json<SeedlingRecipe>(json);
  if (recipe.pot.soil_below_mm.max + 15 > recipe.pot.height_mm.min)
    throw bad_input("recipe field 'pot.soil_below_mm' leaves less than 15 mm of soil", "a deeper pot or more soil");
  return recipe;
}

SeedlingRecipe read_seedling(const std::string& name_or_path) {
  return parse_recipe_file(find_recipe("plants", name_or_path), parse_seedling);
}

nlohmann::json seedling_json(const SeedlingRecipe& recipe) {
  nlohmann::json json = nlohmann::json::object();
  each_field(recipe, RecipeWriter(json));
  return json;
}

std::vector<std::string> seedling_names() { return recipe_names("plants"); }

}  // namespace bole::sim
