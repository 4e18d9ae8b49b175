#include "sim/core/plot/recipe.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"
#include "sim/core/plot/recipe_fields.h"

namespace bole::sim {

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, LayoutRecipe> {
  visit("kind", r.kind, 0, 0);
  visit("min_spacing_m", r.min_spacing_m, 0.3, 10);
  visit("clustering", r.clustering, 0, 1);
  visit("row_spacing_m", r.row_spacing_m, 0.5, 20);
  visit("plant_spacing_m", r.plant_spacing_m, 0.3, 20);
  visit("row_azimuth_deg", r.row_azimuth_deg, -360, 360);
  visit("position_sd_m", r.position_sd_m, 0, 1);
  visit("missing_share", r.missing_share, 0, 0.9);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, SpeciesRecipe> {
  visit("name", r.name, 0, 0);
  visit("form", r.form, 0, 0);
  visit("share", r.share, 0.001, 1000);
  visit("bark_mm", r.bark_mm, 0, 30);
  visit("ovality", r.ovality, 0, 0.1);
  visit("flare", r.flare, 0, 1);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, TreeRecipe> {
  visit("count", r.count, 0, 5000);
  visit("dbh_mean_cm", r.dbh_mean_cm, 2, 200);
  visit("dbh_sd_cm", r.dbh_sd_cm, 0, 60);
  visit("dbh_min_cm", r.dbh_min_cm, 1, 100);
  visit("dbh_max_cm", r.dbh_max_cm, 2, 250);
  visit("conifer_share", r.conifer_share, 0, 1);
  visit("dead_share", r.dead_share, 0, 1);
  visit("fork_share", r.fork_share, 0, 1);
  visit("twin_share", r.twin_share, 0, 0.5);
  visit("lean_sd_deg", r.lean_sd_deg, 0, 15);
  visit("sweep_m", r.sweep_m, 0, 0.5);
  visit("ovality", r.ovality, 0, 0.1);
  visit("flare", r.flare, 0, 1);
  visit("bark_mm", r.bark_mm, 0, 30);
  visit("low_branches", r.low_branches, 0, 10);
  visit("species", r.species, 0, 50);
  visit("buttress_share", r.buttress_share, 0, 1);
  visit("leaning_share", r.leaning_share, 0, 1);
  visit("coppice_share", r.coppice_share, 0, 0.95);
  visit("coppice_stems", r.coppice_stems, 2, 9);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, TerrainRecipe> {
  visit("slope_deg", r.slope_deg, 0, 45);
  visit("aspect_deg", r.aspect_deg, -360, 360);
  visit("undulation_m", r.undulation_m, 0, 5);
  visit("undulation_scale_m", r.undulation_scale_m, 2, 200);
  visit("micro_relief_m", r.micro_relief_m, 0, 0.3);
  visit("rocks_per_ha", r.rocks_per_ha, 0, 5000);
  visit("fallen_stems_per_ha", r.fallen_stems_per_ha, 0, 2000);
  visit("fallen_max_cm", r.fallen_max_cm, 7, 80);
  visit("stumps_per_ha", r.stumps_per_ha, 0, 2000);
  visit("terrace_width_m", r.terrace_width_m, 0, 30);
  visit("terrace_riser_m", r.terrace_riser_m, 0.3, 10);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, UnderstoreyRecipe> {
  visit("shrubs_per_ha", r.shrubs_per_ha, 0, 10000);
  visit("saplings_per_ha", r.saplings_per_ha, 0, 10000);
  visit("grass_per_ha", r.grass_per_ha, 0, 50000);
  visit("poles_per_ha", r.poles_per_ha, 0, 5000);
  visit("pole_min_cm", r.pole_min_cm, 2, 15);
  visit("pole_max_cm", r.pole_max_cm, 3, 20);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, VineyardRecipe> {
  visit("rows", r.rows, 2, 60);
  visit("row_length_m", r.row_length_m, 5, 180);
  visit("row_spacing_m", r.row_spacing_m, 1.5, 6);
  visit("vine_spacing_m", r.vine_spacing_m, 0.5, 5);
  visit("post_spacing_m", r.post_spacing_m, 1, 20);
  visit("canopy_bottom_m", r.canopy_bottom_m, 0.3, 2);
  visit("canopy_top_m", r.canopy_top_m, 0.8, 3);
  visit("missing_share", r.missing_share, 0, 0.9);
  visit("repeats", r.repeats, 0, 60);
  visit("sheds", r.sheds, 0, 2);
}

template <class R, class V>
void each_field(R& r, V&& visit) requires std::is_same_v<std::remove_const_t<R>, PlotRecipe> {
  visit("name", r.name, 0, 0);
  visit("title", r.title, 0, 0);
  visit("size_m", r.size_m, 4, 100);
  visit("buffer_m", r.buffer_m, 0, 30);
  visit("layout", r.layout, 0, 0);
  visit("trees", r.trees, 0, 0);
  visit("terrain", r.terrain, 0, 0);
  visit("understorey", r.understorey, 0, 0);
  visit("vineyard", r.vineyard, 0, 0);
}

namespace {

void check_relations(const PlotRecipe& r) {
  const auto& t = r.trees;
  const auto& v = r.vineyard;
  if (r.is_vineyard() && std::max(v.row_length_m, (v.rows - 1) * v.row_spacing_m) + 2 * vineyard_headland_m > r.size_m)
    throw bad_input("recipe fields vineyard: " + std::to_string(v.rows) + " rows of " + number_text(v.row_length_m) +
                        " m, " + number_text(v.row_spacing_m) + " m apart, in a plot of " + number_text(r.size_m) +
                        " m",
                    number_text(vineyard_headland_m) + " m of headland on each side", "Raise size_m");
  if (r.is_vineyard() && !(v.canopy_bottom_m < v.canopy_top_m))
    throw bad_input("recipe field 'vineyard.canopy_bottom_m' is " + number_text(v.canopy_bottom_m),
                    "less than canopy_top_m, " + number_text(v.canopy_top_m));
  if (!(t.dbh_min_cm < t.dbh_max_cm))
    throw bad_input(
        "recipe fields trees.dbh_min_cm " + number_text(t.dbh_min_cm) + " and dbh_max_cm " + number_text(t.dbh_max_cm),
        "the smaller one first");
  if (t.dbh_mean_cm < t.dbh_min_cm || t.dbh_mean_cm > t.dbh_max_cm)
    throw bad_input("recipe field 'trees.dbh_mean_cm' is " + number_text(t.dbh_mean_cm),
                    "a mean between dbh_min_cm and dbh_max_cm");
  // A sample within [min, max] of mean m has a variance of at most (m - min)(max - m).
  if (t.dbh_sd_cm * t.dbh_sd_cm > 0.25 * (t.dbh_mean_cm - t.dbh_min_cm) * (t.dbh_max_cm - t.dbh_mean_cm))
    throw bad_input("recipe field 'trees.dbh_sd_cm' is " + number_text(t.dbh_sd_cm),
                    "a spread that fits between dbh_min_cm and dbh_max_cm", "Lower it, or widen the limits");
  const auto& u = r.understorey;
  if (!(u.pole_min_cm < u.pole_max_cm))
    throw bad_input("recipe fields understorey.pole_min_cm " + number_text(u.pole_min_cm) + " and pole_max_cm " +
                        number_text(u.pole_max_cm),
                    "the smaller one first");
  const auto& g = r.terrain;
  if (g.terrace_width_m > 0 && !(g.terrace_riser_m < g.terrace_width_m))
    throw bad_input("recipe field 'terrain.terrace_riser_m' is " + number_text(g.terrace_riser_m),
                    "less than terrace_width_m, " + number_text(g.terrace_width_m));
}

}  // namespace

PlotRecipe parse_recipe(const nlohmann::json& json) {
  auto recipe = recipe_from_json<PlotRecipe>(json);
  check_relations(recipe);
  return recipe;
}

PlotRecipe read_recipe(const std::filesystem::path& file) { return parse_recipe_file(file, parse_recipe); }

nlohmann::json to_json(const PlotRecipe& recipe) {
  auto json = nlohmann::json::object();
  each_field(recipe, RecipeWriter(json));
  return json;
}

}  // namespace bole::sim
