// Stands that are harder to measure: species, buttresses, leaning stems, stools, poles, terraces, stumps.
#include "sim/core/plot/stand.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "base/angles.h"
#include "base/error.h"
#include "base/resources.h"
#include "modules/sim/plots.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/plot/truth.h"
#include "sim/core/walk/route.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {
namespace {

const std::vector<std::string> stands{"broadleaf", "mixed_stand", "coppice", "slope30", "terraces"};

TEST(Stand, shipped_stands_have_free_stems_on_their_side_and_the_moments_of_their_recipe) {
  for (const auto& name : stands)
    for (const std::uint64_t seed : {1, 5}) {
      const Forest forest = shipped(name, seed);
      double n = 0, sum = 0, squares = 0;
      for (const auto& a : forest.trees) {
        EXPECT_EQ(a.in_plot, a.taped.centre.head<2>().cwiseAbs().maxCoeff() < forest.half_side_m()) << name << a.id;
        if (a.in_plot && !a.pole) {
          const double d = 100 * a.taped.diameter_m;
          n += 1;
          sum += d;
          squares += d * d;
        }
        for (const auto& b : forest.trees) {
          if (a.id >= b.id || !a.in_plot) continue;
          const double gap =
              (a.taped.centre - b.taped.centre).head<2>().norm() - 0.5 * (a.taped.diameter_m + b.taped.diameter_m);
          EXPECT_GT(gap, 0.01) << name << " " << seed << ": " << a.id << " and " << b.id;
        }
      }
      const auto& t = forest.recipe.trees;
      EXPECT_EQ(n, t.count) << name;
      EXPECT_NEAR(sum / n, t.dbh_mean_cm, 0.005) << name;
      EXPECT_NEAR(std::sqrt(squares / n - sum * sum / n / n), t.dbh_sd_cm, 0.01) << name;
    }
}

TEST(Stand, species_have_their_share_and_their_bark) {
  std::map<std::string, double> count, bark;
  double trees = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Forest forest = shipped("broadleaf", seed);
    for (const auto& tree : forest.trees) {
      if (tree.pole) continue;
      trees += 1;
      count[tree.species_name] += 1;
      bark[tree.species_name] += 1000 * tree.stem.bark_depth_m;
    }
  }
  ASSERT_EQ(count.size(), 4u);
  EXPECT_NEAR(count["beech"] / trees, 0.45, 0.05);
  EXPECT_NEAR(count["oak"] / trees, 0.25, 0.05);
  EXPECT_NEAR(bark["beech"] / count["beech"], 1, 0.1);
  EXPECT_NEAR(bark["oak"] / count["oak"], 12, 1);
}

TEST(Stand, poles_are_in_the_truth_with_their_taped_diameter) {
  const Forest forest = shipped("broadleaf", 2);
  const auto poles = std::ranges::count_if(forest.trees, &Tree::pole);
  EXPECT_NEAR(static_cast<double>(poles), 500 * 56 * 56 / 1e4, 1);
  for (const auto& tree : forest.trees) {
    if (!tree.pole) continue;
    EXPECT_GE(100 * tree.taped.diameter_m, 3 - 1e-6);
    EXPECT_LE(100 * tree.taped.diameter_m, 9 + 1e-6);
  }
  const Table table = tree_table(forest);
  EXPECT_EQ(table.rows(), forest.trees.size());
  EXPECT_TRUE(table.has("bark_mm"));
  EXPECT_FALSE(tree_table(shipped("demo", 1)).has("bark_mm"));
}

TEST(Stand, stools_hold_several_stems_that_leave_one_base) {
  const Forest forest = shipped("coppice", 3);
  std::map<int, int> stems;
  double in_stools = 0, trees = 0;
  for (const auto& tree : forest.trees) {
    if (!tree.in_plot || tree.pole) continue;
    trees += 1;
    if (tree.twin_of == 0) continue;
    stems[tree.twin_of] += 1;
    const Tree& leader = forest.trees[static_cast<std::size_t>(tree.twin_of) - 1];
    EXPECT_EQ(leader.twin_of, 0);
    EXPECT_LT((tree.stem.foot - leader.stem.foot).head<2>().norm(), 1.0);
  }
  for (const auto& [leader, others] : stems) {
    in_stools += 1 + others;
    EXPECT_LE(1 + others, forest.recipe.trees.coppice_stems);
  }
  EXPECT_NEAR(in_stools / trees, 0.75, 0.15);
}

TEST(Stand, leaning_stems_lean_and_buttresses_reach_breast_height) {
  PlotRecipe recipe = bare_plot(12);
  recipe.size_m = 20;
  recipe.trees.dbh_mean_cm = 40;
  recipe.trees.dbh_sd_cm = 0;
  const Forest plain = make_forest(recipe, 1);
  recipe.trees.leaning_share = 1;
  recipe.trees.buttress_share = 1;
  const Forest hard = make_forest(recipe, 1);
  int leaning = 0;
  for (std::size_t i = 0; i < hard.trees.size(); ++i) {
    const Tree &a = plain.trees[i], &b = hard.trees[i];
    EXPECT_LT(std::acos(a.taped.axis.z()), 0.02);
    const double lean = deg_per_rad * std::acos(b.taped.axis.z());
    if (lean > 5) {
      ++leaning;
      EXPECT_GT(lean, 9);
      EXPECT_LT(lean, 21);
    }
    // The tape goes over the lobes: the section is hollow between them, by centimetres.
    double least = 1e9, most = 0;
    for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.05) {
      least = std::min(least, b.stem.radius(b.taped.h, angle));
      most = std::max(most, b.stem.radius(b.taped.h, angle));
    }
    EXPECT_GT(most - least, 0.005);
    EXPECT_NEAR(b.taped.diameter_m, 0.4, 1e-6);
  }
  EXPECT_GE(leaning, 8);
}

TEST(Stand, terraces_climb_like_the_slope_with_level_treads) {
  TerrainRecipe recipe;
  recipe.slope_deg = 20;
  recipe.aspect_deg = 180;
  recipe.undulation_m = recipe.micro_relief_m = 0;
  recipe.terrace_width_m = 5;
  recipe.terrace_riser_m = 1;
  const Terrain terrain(recipe, 1);
  double level = 0, steepest = 0, n = 0;
  for (double x = -10; x <= 10; x += 0.7)
    for (double y = -10; y <= 10; y += 0.05) {
      const double slope = (terrain.height(x, y + 0.02) - terrain.height(x, y - 0.02)) / 0.04;
      level += std::abs(slope) < 0.01;
      steepest = std::max(steepest, slope);
      n += 1;
    }
  EXPECT_GT(level / n, 0.7);
  EXPECT_GT(steepest, std::tan(radians(60)));
  EXPECT_NEAR(terrain.height(0, 15) - terrain.height(0, -15), 30 * std::tan(radians(20)), 2);
}

TEST(Stand, shipped_stands_can_be_walked) {
  for (const auto& name : stands) {
    const Forest forest = shipped(name, 1);
    const PlotScene scene = build_scene(forest, 1);
    const auto route =
        plan_route(walk_pattern(forest.recipe.size_m, 6), forest, scene.vegetation.obstacles, Walk::step_m);
    EXPECT_GT(route.size(), 400u) << name;
    double nearest = 10;
    for (const auto& p : route)
      for (const auto& tree : forest.trees)
        nearest = std::min(nearest, (p - tree.stem.axis(0.9).head<2>()).norm() - tree.stem.mean_radius(0.9));
    EXPECT_GT(nearest, 0.1) << name;
  }
}

TEST(Stand, wrong_fields_are_named) {
  const auto error = [](const char* json) -> std::string {
    try {
      parse_recipe(nlohmann::json::parse(json));
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error(R"({"trees": {"species": [{"name": "beech"}, {"name": "oak", "bark_mm": 99}]}})"),
              testing::HasSubstr("trees.species[1].bark_mm"));
  EXPECT_THAT(error(R"({"trees": {"species": [{"bork": 1}]}})"), testing::HasSubstr("trees.species[0].bork"));
  EXPECT_THAT(error(R"({"trees": {"species": "oak"}})"), testing::HasSubstr("a list"));
  EXPECT_THAT(error(R"({"understorey": {"pole_min_cm": 9, "pole_max_cm": 4}})"), testing::HasSubstr("pole_min_cm"));
  EXPECT_THAT(error(R"({"terrain": {"terrace_width_m": 2, "terrace_riser_m": 3}})"),
              testing::HasSubstr("terrace_riser_m"));
  // What is written is read again.
  const PlotRecipe recipe = read_recipe(resource_path("plots/coppice.json"));
  EXPECT_EQ(to_json(parse_recipe(to_json(recipe))), to_json(recipe));
}

}  // namespace
}  // namespace bole::sim
