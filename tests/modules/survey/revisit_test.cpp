#include "survey/core/revisit/revisit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "base/random.h"

namespace bole::survey {
namespace {

struct Stand {
  std::vector<double> x, y, dbh, se;  // true places and diameters, standard errors of a survey
};

// Trees at random, 1 m apart at least, with the diameters of a managed stand and the errors of good stems.
Stand random_stand(std::uint64_t seed, int trees = 60, double side = 32) {
  Random random(seed, 7);
  Stand s;
  while (static_cast<int>(s.x.size()) < trees) {
    const double x = random.uniform(-side / 2, side / 2), y = random.uniform(-side / 2, side / 2);
    bool free = true;
    for (std::size_t i = 0; i < s.x.size(); ++i) free = free && std::hypot(s.x[i] - x, s.y[i] - y) > 1;
    if (!free) continue;
    s.x.push_back(x), s.y.push_back(y);
    s.dbh.push_back(std::clamp(random.normal(24, 7), 9.0, 60.0));
    s.se.push_back(random.uniform(0.22, 0.34));  // as good stems of a plot walked in lanes have them
  }
  return s;
}

struct Axes2 {
  double turn = 0, x = 0, y = 0;
  bool mirrored = false;
};

// The table that a survey makes of a stand: errors of its own on top of one that all diameters share.
Table surveyed(const Stand& s, double growth_cm, std::uint64_t seed, const Axes2& axes = {}, double shared_cm = 0.1) {
  Random random(seed, 11);
  const double shared = random.normal(0, shared_cm);
  Table t;
  std::vector<double> x, y, dbh, lo, hi;
  std::vector<std::int64_t> id;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double px = axes.mirrored ? -s.x[i] : s.x[i], py = s.y[i];
    const double own = std::sqrt(std::max(0.0, s.se[i] * s.se[i] - shared_cm * shared_cm));
    const double d = s.dbh[i] + growth_cm + shared + random.normal(0, own);
    id.push_back(static_cast<std::int64_t>(i) + 1);
    x.push_back(std::cos(axes.turn) * px - std::sin(axes.turn) * py + axes.x + random.normal(0, 0.02));
    y.push_back(std::sin(axes.turn) * px + std::cos(axes.turn) * py + axes.y + random.normal(0, 0.02));
    dbh.push_back(d), lo.push_back(d - 1.96 * s.se[i]), hi.push_back(d + 1.96 * s.se[i]);
  }
  t.set("tree_id", id);
  t.set("x_m", x), t.set("y_m", y), t.set("dbh_cm", dbh), t.set("dbh_lo_cm", lo), t.set("dbh_hi_cm", hi);
  return t;
}

RevisitOptions after(double years) {
  RevisitOptions o;
  o.years = years;
  return o;
}

Revisit compared(const Table& a, const Table& b, const RevisitOptions& o) {
  return revisit(a, b, nullptr, nullptr, o, {});
}

double value_of(const Revisit& r, const std::string& measure, const char* column = "value") {
  const auto& names = r.values.texts("measure");
  const auto it = std::ranges::find(names, measure);
  EXPECT_NE(it, names.end()) << measure;
  return it == names.end() ? std::nan("") : r.values.numbers(column)[static_cast<std::size_t>(it - names.begin())];
}

std::string kind_of_first(const Revisit& r, const std::string& id) {
  const auto& ids = r.growth.texts("tree_id");
  const auto it = std::ranges::find(ids, id);
  return it == ids.end() ? "" : r.growth.texts("kind")[static_cast<std::size_t>(it - ids.begin())];
}
std::string kind_of_second(const Revisit& r, const std::string& id) {
  const auto& ids = r.growth.texts("tree_id_second");
  const auto it = std::ranges::find(ids, id);
  return it == ids.end() ? "" : r.growth.texts("kind")[static_cast<std::size_t>(it - ids.begin())];
}

// Half a centimetre a year is told from none after three years, and a stand that did not grow is not said to have.
TEST(Revisit, GrowthIsToldFromNone) {
  int grown = 0, found = 0, false_change = 0, unchanged = 0, mean_held = 0;
  constexpr int plots = 40;
  for (std::uint64_t seed = 1; seed <= plots; ++seed) {
    const auto stand = random_stand(seed);
    const auto first = surveyed(stand, 0, 100 + seed);
    const Axes2 axes{static_cast<double>(seed), 500 + static_cast<double>(seed), -30};
    const auto grew = compared(first, surveyed(stand, 1.5, 200 + seed, axes), after(3));
    ASSERT_EQ(grew.report.counts.at("matched"), 60);
    for (const auto& c : grew.growth.texts("change")) ++found, grown += c == "grew";
    mean_held += value_of(grew, "mean_growth", "lo") <= 1.5 && value_of(grew, "mean_growth", "hi") >= 1.5;
    const auto same = compared(first, surveyed(stand, 0, 300 + seed, axes), after(3));
    for (const auto& c : same.growth.texts("change")) ++unchanged, false_change += c != "none";
  }
  EXPECT_GE(grown, 0.95 * found) << grown << " of " << found;
  EXPECT_LE(false_change, 0.05 * unchanged) << false_change << " of " << unchanged;
  EXPECT_GE(mean_held, 0.85 * plots) << "interval of the mean growth";
}

TEST(Revisit, TheMotionIsFoundFromAnyTurnAndShift) {
  const auto stand = random_stand(3);
  const auto first = surveyed(stand, 0, 1);
  for (const double turn : {0.0, 0.7, 1.9, 3.14, -2.4}) {
    const auto r = compared(first, surveyed(stand, 1, 2, {turn, 1e5, 6e6}), after(2));
    EXPECT_NEAR(std::remainder(r.report.metrics.at("turn").value + turn * 180 / std::numbers::pi, 360), 0, 0.1);
    EXPECT_LT(r.report.metrics.at("distance_rms").value, 5);
    const auto &a = r.growth.texts("tree_id"), &b = r.growth.texts("tree_id_second");
    EXPECT_EQ(a, b);
  }
}

TEST(Revisit, TheSameTableTwiceHasNotGrown) {
  const auto first = surveyed(random_stand(4), 0, 1);
  const auto r = compared(first, first, after(1));
  EXPECT_EQ(r.report.counts.at("grew"), 0);
  EXPECT_EQ(r.report.counts.at("shrank"), 0);
  for (const double g : r.growth.numbers("growth_cm")) EXPECT_EQ(g, 0);
  EXPECT_NEAR(r.report.metrics.at("distance_rms").value, 0, 1e-6);
}

TEST(Revisit, OtherStandsAndMirroredOnesAreRefused) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto stand = random_stand(seed), other = random_stand(seed + 50);
    const auto first = surveyed(stand, 0, 1);
    EXPECT_THROW(compared(first, surveyed(other, 0, 2), after(1)), Error) << seed;
    EXPECT_THROW(compared(first, surveyed(stand, 0, 2, {0.3, 1, 2, true}), after(1)), Error) << seed;
    const auto few = random_stand(seed, 10), few_other = random_stand(seed + 50, 10);
    EXPECT_THROW(compared(surveyed(few, 0, 1), surveyed(few_other, 0, 2), after(1)), Error) << seed;
  }
}

// A plantation of equal trees looks the same from both ends; one of unequal trees does not.
TEST(Revisit, EvenRowsAreRefusedUnlessTheirDiametersTell) {
  Stand rows;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      rows.x.push_back(2.5 * i), rows.y.push_back(2.5 * j);
      rows.dbh.push_back(20), rows.se.push_back(0.3);
    }
  const Axes2 axes{1, 50, 50};
  EXPECT_THROW(compared(surveyed(rows, 0, 1), surveyed(rows, 1, 2, axes), after(2)), Error);
  RevisitOptions same = after(2);
  same.axes = RevisitAxes::same;
  EXPECT_EQ(compared(surveyed(rows, 0, 1), surveyed(rows, 1, 2), same).report.counts.at("matched"), 64);
  Random random(1, 1);
  for (auto& d : rows.dbh) d = random.uniform(12, 36);
  const auto r = compared(surveyed(rows, 0, 1), surveyed(rows, 1, 2, axes), after(2));
  EXPECT_EQ(r.growth.texts("tree_id"), r.growth.texts("tree_id_second"));
}

Table with(const Table& t, double x, double y, double dbh) {
  Table out;
  for (const auto& column : t.columns()) {
    if (column.name == "tree_id") {
      auto v = t.integers("tree_id");
      v.push_back(1000 + static_cast<std::int64_t>(v.size()));
      out.set(column.name, std::move(v));
      continue;
    }
    auto v = t.numbers(column.name);
    v.push_back(column.name == "x_m"         ? x
                : column.name == "y_m"       ? y
                : column.name == "dbh_lo_cm" ? dbh - 0.5
                : column.name == "dbh_hi_cm" ? dbh + 0.5
                                             : dbh);
    out.set(column.name, std::move(v));
  }
  return out;
}

Table without(const Table& t, const std::set<std::size_t>& rows) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < t.rows(); ++i)
    if (!rows.contains(i)) kept.push_back(i);
  return t.subset(kept);
}

std::size_t nearest_to_middle(const Stand& s, std::size_t rank = 0) {
  std::vector<std::size_t> order(s.x.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::hypot(s.x[i], s.y[i]); });
  return order[rank];
}

TEST(Revisit, WhatCameAndWentIsToldFromWhatWasMissed) {
  auto stand = random_stand(5);
  const auto gone = nearest_to_middle(stand), missed = nearest_to_middle(stand, 1);
  const auto first = surveyed(stand, 0, 1);
  auto second = without(surveyed(stand, 1, 2), {gone, missed});
  second = with(second, 3.3, 4.1, 9.0);   // id 1058
  second = with(second, -5.2, -3.7, 30);  // id 1059
  second = with(second, 60, 0, 20);       // id 1060
  Table rejected;
  rejected.set("x_m", std::vector<double>{stand.x[missed] + 0.1});
  rejected.set("y_m", std::vector<double>{stand.y[missed]});
  const auto r = revisit(first, second, nullptr, &rejected, after(2), {});
  EXPECT_EQ(kind_of_first(r, std::to_string(gone + 1)), "gone");
  EXPECT_EQ(kind_of_first(r, std::to_string(missed + 1)), "missed_in_second");
  EXPECT_EQ(kind_of_second(r, "1058"), "ingrowth");
  EXPECT_EQ(kind_of_second(r, "1059"), "missed_in_first") << "30 cm do not grow in two years";
  EXPECT_EQ(kind_of_second(r, "1060"), "outside_first");
  EXPECT_EQ(value_of(r, "gone"), 1);
  EXPECT_EQ(value_of(r, "ingrowth"), 1);
  EXPECT_GT(value_of(r, "mortality_per_year", "hi"), value_of(r, "mortality_per_year"));
}

TEST(Revisit, ATreeListedTwiceIsNoIngrowth) {
  const auto stand = random_stand(6);
  const auto i = nearest_to_middle(stand);
  const auto second = with(surveyed(stand, 1, 2), stand.x[i] + 0.1, stand.y[i], stand.dbh[i] + 1);
  const auto r = compared(surveyed(stand, 0, 1), second, after(2));
  EXPECT_EQ(r.report.counts.at("duplicate_second"), 1);
  EXPECT_EQ(value_of(r, "ingrowth"), 0);
}

TEST(Revisit, PlotsThatOverlapByHalfAreBroughtTogether) {
  const auto stand = random_stand(7, 100, 40);
  std::set<std::size_t> west, east;
  for (std::size_t i = 0; i < stand.x.size(); ++i) (stand.x[i] < -5 ? west : east).insert(i);
  std::set<std::size_t> far_east;
  for (std::size_t i = 0; i < stand.x.size(); ++i)
    if (stand.x[i] > 8) far_east.insert(i);
  const auto r =
      compared(without(surveyed(stand, 0, 1), west), without(surveyed(stand, 1, 2, {2, 9, 9}), far_east), after(2));
  EXPECT_EQ(r.report.counts.at("matched"), static_cast<std::int64_t>(100 - west.size() - far_east.size()));
  EXPECT_EQ(r.report.counts.count("gone"), 0u) << "trees beyond the edge are not dead";
}

TEST(Revisit, YearsComeFromTheDatesOfTheTables) {
  const auto stand = random_stand(8);
  auto first = surveyed(stand, 0, 1), second = surveyed(stand, 1, 2);
  EXPECT_FALSE(compared(first, second, {}).growth.has("growth_cm_per_year"));
  first.facts["date"] = "2021-05-31", second.facts["date"] = "2024-05-31";
  EXPECT_NEAR(compared(first, second, {}).report.metrics.at("years").value, 3, 0.01);
  EXPECT_THROW(compared(second, first, {}), Error) << "the wrong way round";
}

}  // namespace
}  // namespace bole::survey
