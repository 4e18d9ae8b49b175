#include "evaluation/core/evaluate_plants.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "base/error.h"

namespace bole::evaluation {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

double plant_measure(const PlantEvaluation& e, const char* name) {
  const auto& names = e.summary.texts("measure");
  const auto at = std::ranges::find(names, name);
  return at == names.end() ? std::numeric_limits<double>::quiet_NaN()
                           : e.summary.numbers("value")[static_cast<std::size_t>(at - names.begin())];
}

Table manual() {
  Table t;
  t.set("plant_id", Texts{"a", "b", "c"});
  t.set("height_mm", Numbers{100, 200, 400});
  t.set("leaf_count", std::vector<std::int64_t>{10, 20, 0});
  return t;
}

TEST(EvaluatePlants, AccuracyBiasAndIntervals) {
  Table t;
  t.set("plant_id", Texts{"c", "x", "a", "b"});
  t.set("height_mm", Numbers{404, 1, 98, 200});
  t.set("height_lo_mm", Numbers{402, 0, 95, 190});
  t.set("height_hi_mm", Numbers{406, 2, 101, 210});
  t.set("leaf_count", std::vector<std::int64_t>{3, 3, 9, 22});
  t.set("leaf_area_cm2", Numbers{1, 2, 3, 4});
  const auto e = evaluate_plants(t, manual());
  EXPECT_EQ(plant_measure(e, "height_mm_plants"), 3);
  EXPECT_NEAR(plant_measure(e, "height_mm_accuracy"), 100 * (1 - (0.01 + 0.02 + 0) / 3), 1e-12);
  EXPECT_NEAR(plant_measure(e, "height_mm_bias"), 2.0 / 3, 1e-12);
  EXPECT_NEAR(plant_measure(e, "height_mm_rmse"), std::sqrt(20.0 / 3), 1e-12);
  EXPECT_NEAR(plant_measure(e, "height_mm_in_interval"), 200.0 / 3, 1e-12);
  EXPECT_GT(plant_measure(e, "height_mm_r2"), 0.999);
  // A reference of zero has no relative error.
  EXPECT_EQ(plant_measure(e, "leaf_count_plants"), 2);
  EXPECT_NEAR(plant_measure(e, "leaf_count_accuracy"), 90, 1e-12);
  EXPECT_TRUE(std::isnan(plant_measure(e, "leaf_count_in_interval")));
  EXPECT_EQ(e.plants.rows(), 5u);
}

TEST(EvaluatePlants, OnePlantNeedsNoName) {
  Table a, b;
  a.set("plant_id", Texts{"this"});
  a.set("height_mm", Numbers{99});
  b.set("height_mm", Numbers{100});
  EXPECT_NEAR(plant_measure(evaluate_plants(a, b), "height_mm_accuracy"), 99, 1e-12);
}

TEST(EvaluatePlants, RefusesWhatCannotBeCompared) {
  Table other = manual();
  other.set("plant_id", Texts{"x", "y", "z"});
  EXPECT_THROW(evaluate_plants(other, manual()), Error);
  other.set("plant_id", Texts{"a", "a", "b"});
  EXPECT_THROW(evaluate_plants(other, manual()), Error);
  Table words;
  words.set("plant_id", Texts{"a", "b", "c"});
  words.set("height_mm", Texts{"low", "high", ""});
  EXPECT_THROW(evaluate_plants(words, manual()), Error);
}

}  // namespace
}  // namespace bole::evaluation
