#include "sim/core/plot/recipe.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/resources.h"

namespace bole::sim {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string error_of(const json& recipe) {
  try {
    parse_recipe(recipe);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
  }
  return "";
}

TEST(Recipe, plots_of_the_source_have_its_figures) {
  const struct {
    const char* name;
    int count;
    double mean, sd;
  } plots[] = {
      {"plot1", 74, 20.30, 5.14}, {"plot2", 58, 27.10, 2.65}, {"plot3", 78, 16.86, 4.64}, {"plot4", 72, 18.25, 2.30}};
  for (const auto& p : plots) {
    const PlotRecipe recipe = read_recipe(resource_path(std::string("plots/") + p.name + ".json"));
    EXPECT_EQ(recipe.size_m, 32);
    EXPECT_EQ(recipe.trees.count, p.count);
    EXPECT_EQ(recipe.trees.dbh_mean_cm, p.mean);
    EXPECT_EQ(recipe.trees.dbh_sd_cm, p.sd);
    EXPECT_GE(recipe.trees.dbh_min_cm, 7.5);
  }
}

TEST(Recipe, every_recipe_that_comes_with_bole_is_valid) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(resource_path("plots"))) {
    if (entry.path().extension() != ".json") continue;  // a walk
    const PlotRecipe recipe = read_recipe(entry.path());
    EXPECT_EQ(recipe.name, entry.path().stem().string());
    EXPECT_FALSE(recipe.title.empty());
    ++count;
  }
  EXPECT_GE(count, 7);
}

TEST(Recipe, what_is_written_reads_back) {
  PlotRecipe recipe;
  recipe.name = "mine";
  recipe.trees.count = 7;
  recipe.terrain.slope_deg = 12.5;
  recipe.layout.kind = LayoutKind::rows;
  const json written = to_json(recipe);
  EXPECT_EQ(to_json(parse_recipe(written)), written);
  EXPECT_EQ(written["trees"]["count"], 7);
}

TEST(Recipe, errors_name_the_field_the_value_and_the_need) {
  EXPECT_THAT(error_of({{"trees", {{"count", -3}}}}),
              testing::AllOf(HasSubstr("trees.count"), HasSubstr("-3"), HasSubstr("whole number from 0 to 5000")));
  EXPECT_THAT(error_of({{"trees", {{"dbh_mean_cm", "thick"}}}}),
              testing::AllOf(HasSubstr("trees.dbh_mean_cm"), HasSubstr("thick")));
  EXPECT_THAT(error_of({{"terrain", {{"slop_deg", 3}}}}),
              testing::AllOf(HasSubstr("terrain.slop_deg"), HasSubstr("Did you mean 'slope_deg'")));
  EXPECT_THAT(error_of({{"layout", {{"kind", "spiral"}}}}), HasSubstr("one of natural, rows, vineyard"));
  EXPECT_THAT(error_of({{"trees", {{"dbh_sd_cm", 40}}}}), HasSubstr("dbh_sd_cm"));
  EXPECT_THAT(error_of(json::array()), HasSubstr("a JSON object"));
  EXPECT_THAT(error_of({{"trees", 5}}), HasSubstr("'trees'"));
}

TEST(Recipe, missing_and_broken_files_are_named) {
  try {
    read_recipe("/nowhere/plot.json");
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("/nowhere/plot.json"));
  }
}

}  // namespace
}  // namespace bole::sim
