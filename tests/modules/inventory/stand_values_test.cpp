#include "inventory/core/stand_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "cloud/plot_area.h"
#include "inventory/core/plot_values.h"
#include "io/core/tables/table_file.h"
#include "real_data.h"

namespace bole::inventory {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double height_of(double d) { return 1.3 + d * d / std::pow(1.4 + 0.19 * d, 2); }

TEST(HeightCurve, ComesBackFromItsOwnHeights) {
  std::vector<SizedStem> stems;
  for (double d = 10; d <= 40; d += 2) stems.push_back({d, 0.2, height_of(d), nan});
  const auto c = fit_height_curve(stems);
  ASSERT_TRUE(c);
  EXPECT_NEAR(c->a, 1.4, 1e-9);
  EXPECT_NEAR(c->b, 0.19, 1e-9);
  EXPECT_NEAR(c->rmse_m, 0, 1e-9);
  EXPECT_NEAR(c->height_m(25), height_of(25), 1e-9);
  EXPECT_TRUE(std::isnan(c->height_m(7)));  // not carried further
  EXPECT_TRUE(std::isnan(c->height_m(60)));
  stems[3].height_m = 60;  // a neighbour's top
  EXPECT_NEAR(fit_height_curve(stems)->height_m(25), height_of(25), 0.1);
  stems.resize(7);
  EXPECT_FALSE(fit_height_curve(stems));
}

TEST(HeightCurve, BeginsAtTheBreastHeightOfTheStems) {
  std::vector<SizedStem> stems;
  for (double d = 10; d <= 40; d += 2) stems.push_back({d, 0.2, height_of(d) + 0.07, nan});
  const auto c = fit_height_curve(stems, 1.37);
  ASSERT_TRUE(c);
  EXPECT_NEAR(c->b, 0.19, 1e-9);
  EXPECT_NEAR(c->height_m(25), height_of(25) + 0.07, 1e-9);
  const auto v = stand_values(stems, {1.37, 0}), usual = stand_values(stems);
  EXPECT_NEAR(v.curve->a, 1.4, 1e-9);
  // Measured higher up, the same diameter makes a thicker stem.
  EXPECT_NEAR(form_volume_m3(20, 15, 1.37) / form_volume_m3(20, 15), std::pow(13.7 / 13.63, 1.5), 1e-12);
  EXPECT_GT(v.volume_m3, usual.volume_m3);
  EXPECT_LT(v.volume_m3_half.measured, usual.volume_m3_half.measured);  // a form that is known
}

TEST(StandValues, UnsureFormWidensTheIntervalOfTheVolume) {
  std::vector<SizedStem> stems;
  for (double d = 10; d <= 40; d += 1) stems.push_back({d, 0.2, height_of(d), nan});
  const auto sure = stand_values(stems, {1.3, 0}), unsure = stand_values(stems, {1.3, 8});
  EXPECT_EQ(unsure.volume_m3, sure.volume_m3);
  EXPECT_NEAR(unsure.volume_m3_half.measured,
              std::hypot(sure.volume_m3_half.measured, 1.959964 * 0.08 * sure.volume_m3), 1e-9);
}

TEST(StandValues, UnseenTopsComeFromTheCurve) {
  std::vector<SizedStem> stems;
  for (double d = 10; d <= 40; d += 1) stems.push_back({d, 0.2, std::lround(d) % 3 == 0 ? nan : height_of(d), nan});
  const auto v = stand_values(stems);
  EXPECT_EQ(v.by_curve, 10U);
  double g = 0, gh = 0, volume = 0;
  for (const auto& s : stems) {
    const double h = height_of(s.dbh_cm);
    g += s.dbh_cm * s.dbh_cm, gh += s.dbh_cm * s.dbh_cm * h, volume += form_volume_m3(s.dbh_cm, h);
  }
  EXPECT_NEAR(v.lorey_height_m, gh / g, 1e-6);
  EXPECT_NEAR(v.volume_m3, volume, 1e-6);
}

// The stem cut into thin discs whose cross section shrinks with the power 1.5 of the way to the top, through DBH.
TEST(StandValues, AStemBetweenParaboloidAndConeHoldsItsDiscs) {
  constexpr double height = 15, dbh_m = 0.31, step = 1e-3;
  double discs = 0;
  for (double h = step / 2; h < height; h += step)
    discs += step * std::numbers::pi / 4 * dbh_m * dbh_m * std::pow((height - h) / (height - 1.3), 1.5);
  EXPECT_NEAR(form_volume_m3(31, 15), discs, 1e-6);
  // The form factor that the header names: volume by that of a cylinder of DBH and height.
  EXPECT_NEAR(form_volume_m3(31, 15) / (std::numbers::pi / 4 * dbh_m * dbh_m * height), 0.458, 5e-4);
  EXPECT_TRUE(std::isnan(form_volume_m3(20, nan)));
}

// The interval of the basal area holds the truth as often as it says, with errors that are partly shared.
TEST(StandValues, IntervalsOfSumsHold) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  int held = 0, held_dq = 0;
  constexpr int rounds = 2000, n = 60;
  for (int r = 0; r < rounds; ++r) {
    const double shared = normal(random);
    double truth = 0, measured = 0, true_squares = 0, squares = 0;
    std::vector<SizedStem> stems;
    for (int i = 0; i < n; ++i) {
      const double d = 12 + 0.4 * i, e = 0.3 * (0.25 * shared + std::sqrt(1 - 0.0625) * normal(random));
      truth += std::numbers::pi / 40000 * d * d, measured += std::numbers::pi / 40000 * (d + e) * (d + e);
      true_squares += d * d / n, squares += (d + e) * (d + e) / n;
      stems.push_back({d + e, 0.3, nan, nan});
    }
    const auto v = stand_values(stems);
    held += std::abs(measured - truth) <= v.basal_area_m2.measured;
    held_dq += std::abs(std::sqrt(squares) - std::sqrt(true_squares)) <= v.quadratic_mean_dbh_half_cm;
  }
  EXPECT_NEAR(held / static_cast<double>(rounds), 0.95, 0.015);
  EXPECT_NEAR(held_dq / static_cast<double>(rounds), 0.95, 0.015);
}

// A sample of a random stand: the interval of the density holds the true density.
TEST(StandValues, ASampleOfARandomStandHoldsItsDensity) {
  std::mt19937 random(6);
  std::poisson_distribution<int> count(70);
  int held = 0;
  for (int r = 0; r < 3000; ++r) {
    const std::vector<SizedStem> stems(static_cast<std::size_t>(count(random)), {20, 0.2, nan, nan});
    held += std::abs(static_cast<double>(stems.size()) - 70) <= stand_values(stems).stems.sampled;
  }
  EXPECT_NEAR(held / 3000.0, 0.95, 0.015);
}

// Real field lists: 16 circular plots of 20 m; stem counts and basal areas as sums over the list.
TEST(Rioja, PlotValuesOfTheFieldLists) {
  const auto file = std::filesystem::path(BOLE_SHARED_DATA_DIR) / "tables_rioja" / "rioja_tree.field.csv";
  BOLE_NEEDS_REAL(file);
  const auto list = io::read_table(file);
  const CountingRule rule{circle_area({0, 0}, 20), 7.5};
  std::size_t all = 0;
  double ours = 0, theirs = 0;
  int held = 0;
  for (int plot = 1; plot <= 16; ++plot) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < list.rows(); ++i)
      if (list.integers("id")[i] == plot) rows.push_back(i);
    const auto part = list.subset(rows);
    Table t;
    t.set("x_m", part.numbers("x")), t.set("y_m", part.numbers("y")), t.set("dbh_cm", part.numbers("dbh"));
    const auto numbers = [&](const char* column) {  // some are NA
      std::vector<double> values;
      for (std::size_t i = 0; i < part.rows(); ++i) {
        const auto text = part.text(column, i);
        values.push_back(text == "NA" ? nan : std::stod(text));
      }
      return values;
    };
    const auto heights = numbers("h"), field_volume = numbers("v.user");
    t.set("height_m", heights);
    const auto m = plot_values(t, rule, {.class_width_cm = 5});
    double squares = 0, of_plot = 0;
    std::vector<SizedStem> both;  // those with a volume by species table
    const auto dbh = part.numbers("dbh");
    for (std::size_t i = 0; i < dbh.size(); ++i) {
      squares += dbh[i] * dbh[i];
      if (const double v = form_volume_m3(dbh[i], heights[i]); std::isfinite(v) && std::isfinite(field_volume[i]))
        ours += v, theirs += field_volume[i], both.push_back({dbh[i], 0.1, heights[i], nan}),
            of_plot += field_volume[i];
    }
    const auto stand = stand_values(both);
    held += std::abs(stand.volume_m3 - of_plot) <= stand.volume_m3_half.measured;
    EXPECT_EQ(m.stems, part.rows()) << plot;
    EXPECT_NEAR(m.basal_area_m2_per_ha, std::numbers::pi / 40000 * squares / (std::numbers::pi * 0.04), 1e-9) << plot;
    EXPECT_NEAR(m.quadratic_mean_dbh_cm, std::sqrt(squares / static_cast<double>(dbh.size())), 1e-9) << plot;
    all += m.stems;
  }
  EXPECT_EQ(all, list.rows());
  EXPECT_EQ(held, 16);                     // the interval of the volume holds that of the tables, on every plot
  EXPECT_NEAR(ours / theirs, 1.05, 0.02);  // against the volume tables of these species
}

}  // namespace
}  // namespace bole::inventory
