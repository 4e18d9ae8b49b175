// Small plots for tests.
#pragma once

#include "base/resources.h"
#include "sim/core/plot/forest.h"
#include "sim/core/plot/recipe.h"

namespace bole::sim {

// Level, smooth ground with a few upright round trees and nothing else.
inline PlotRecipe bare_plot(int trees = 3) {
  PlotRecipe recipe;
  recipe.name = "bare";
  recipe.size_m = 10;
  recipe.buffer_m = 0;
  recipe.layout.min_spacing_m = 2;
  auto& t = recipe.trees;
  t.count = trees;
  t.dead_share = t.fork_share = t.twin_share = t.low_branches = t.bark_mm = t.ovality = t.lean_sd_deg = t.sweep_m = 0;
  auto& g = recipe.terrain;
  g.slope_deg = g.undulation_m = g.micro_relief_m = g.rocks_per_ha = g.fallen_stems_per_ha = 0;
  auto& u = recipe.understorey;
  u.shrubs_per_ha = u.saplings_per_ha = u.grass_per_ha = 0;
  return recipe;
}

// A plot of resources/plots.
inline Forest shipped(const std::string& plot, std::uint64_t seed) {
  return make_forest(read_recipe(resource_path("plots/" + plot + ".json")), seed);
}

}  // namespace bole::sim
