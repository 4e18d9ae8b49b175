#include "rows/core/rows/find_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "base/angles.h"
#include "base/error.h"
#include "rows/core/rows/line_fit.h"
#include "synthetic/plant_field.h"

namespace bole::rows {
namespace {

using synthetic::BlockRecipe;
using synthetic::FieldMaker;
using synthetic::mixed_field;
using synthetic::PlantField;
using ::testing::HasSubstr;

Table table_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<double> x, y;
  for (const auto& p : points) {
    x.push_back(p.x());
    y.push_back(p.y());
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  return t;
}

FoundRows find(const Table& stems, const RowOptions& options = {}) { return find_rows(stems, options, bole::Run{}); }

// SPEC B, table 1: left row then right row of three trials, and the angles of table 2.
struct Trial {
  std::vector<Eigen::Vector2d> left, right;
  double left_deg, right_deg;
};

const std::vector<Trial>& trials() {
  static const std::vector<Trial> t{{{{3.528, -5.666}, {4.145, -5.682}, {4.797, -5.633}, {5.494, -5.756}},
                                     {{5.424, -6.895}, {4.827, -6.915}, {4.054, -6.989}, {3.602, -6.997}},
                                     -1.97,
                                     3.55},
                                    {{{2.091, 3.605}, {2.683, 3.522}, {3.312, 3.627}, {3.960, 3.445}},
                                     {{2.062, 2.158}, {2.753, 2.187}, {3.253, 2.007}, {3.822, 2.201}},
                                     -3.49,
                                     -0.40},
                                    {{{2.126, 3.914}, {2.803, 3.738}, {3.447, 3.899}, {4.112, 3.837}},
                                     {{2.258, 2.562}, {2.844, 2.444}, {3.532, 2.639}, {4.174, 2.553}},
                                     -0.69,
                                     1.60}};
  return t;
}

TEST(FindRows, TheTrialsOfThePaperGiveTheirPublishedAngles) {
  double worst = 0;
  for (const bool given : {false, true})
    for (const auto& trial : trials()) {
      auto points = trial.left;
      points.insert(points.end(), trial.right.begin(), trial.right.end());
      Table t = table_of(points);
      if (given) t.set("row_id", std::vector<std::int64_t>{1, 1, 1, 1, 2, 2, 2, 2});
      const auto found = find(t);
      ASSERT_EQ(found.rows.rows(), 2U) << found.report.message;
      const auto angle = found.rows.numbers("angle_deg"), se = found.rows.numbers("angle_se_deg");
      EXPECT_EQ(found.rows.integers("plants"), (std::vector<std::int64_t>{4, 4}));
      EXPECT_NEAR(angle[0], trial.left_deg, 0.04);
      EXPECT_NEAR(angle[1], trial.right_deg, 0.04);
      worst = std::max({worst, std::abs(angle[0] - trial.left_deg), std::abs(angle[1] - trial.right_deg)});
      EXPECT_GT(se[0], 0.1);
      EXPECT_LT(se[0], 5);
      EXPECT_NEAR(found.report.metrics.at("row_spacing").value, 1.35, 0.2);
    }
  printf("worst difference from table 2: %.3f deg\n", worst);
}

struct Score {
  int rows = 0, found = 0, matched = 0;  // rows
  int plants = 0, assigned = 0;          // true plants in the matched row
  int strays = 0, strays_kept_out = 0;
  int missing = 0, missing_found = 0, missing_false = 0;
  double worst_angle_deg = 0;
  void add(const Score& s) {
    rows += s.rows;
    found += s.found;
    matched += s.matched;
    plants += s.plants;
    assigned += s.assigned;

    strays += s.strays;
    strays_kept_out += s.strays_kept_out;
    missing += s.missing;

    missing_found += s.missing_found;
    missing_false += s.missing_false;
  }
};

// A found row is right when 90 % of its plants are of one true row and it has 90 % of the plants of that row.
Score score(const PlantField& field, const FoundRows& found) {
  std::map<std::pair<double, double>, const synthetic::FieldPlant*> at;
  for (const auto& p : field.plants) at[{p.at.x(), p.at.y()}] = &p;
  const auto x = found.plants.numbers("x_m"), y = found.plants.numbers("y_m");
  const auto id = found.plants.integers("row_id");
  const auto& state = found.plants.texts("state");
  std::map<std::int64_t, std::map<int, int>> votes;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (state[i] == "present") ++votes[id[i]][at.at({x[i], y[i]})->row];
  std::map<int, int> size;
  Score s;
  for (const auto& p : field.plants) p.row >= 0 ? (void)++size[p.row] : (void)++s.strays;
  s.rows = static_cast<int>(field.rows.size());
  s.found = static_cast<int>(votes.size());
  for (const auto& [row_id, count] : votes) {
    int all = 0, best = -1, shared = 0;
    for (const auto& [row, n] : count) {
      all += n;
      if (row >= 0 && n > shared) {
        best = row;
        shared = n;
      }
    }
    if (best >= 0 && shared >= 0.9 * all && shared >= 0.9 * size[best]) {
      ++s.matched;
      s.assigned += shared;
    }
  }
  s.plants = std::accumulate(size.begin(), size.end(), 0, [](int a, const auto& b) { return a + b.second; });
  const auto sx = found.strays.numbers("x_m"), sy = found.strays.numbers("y_m");
  for (std::size_t i = 0; i < sx.size(); ++i) s.strays_kept_out += at.at({sx[i], sy[i]})->row < 0;
  // A missing plant is found when one is listed within a third of the spacing.
  std::vector<Eigen::Vector2d> listed;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (state[i] == "missing") listed.emplace_back(x[i], y[i]);
  const double near = field.plant_spacing_m / 3;
  for (const auto& row : field.rows)
    for (const auto& m : row.missing_inside) {
      ++s.missing;
      s.missing_found +=
          std::any_of(listed.begin(), listed.end(), [&](const auto& l) { return (l - m).norm() < near; });
    }
  s.missing_false = static_cast<int>(listed.size());
  return s;
}

TEST(FindRows, FiftyMixedFields) {
  Score all;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto field = mixed_field(seed);
    const auto s = score(field, find(field.table()));
    if (s.matched < s.rows || s.matched < s.found || s.assigned < 0.99 * s.plants)
      printf("seed %u: %d rows, %d found, %d right; %d of %d plants; %d of %d missing\n", seed, s.rows, s.found,
             s.matched, s.assigned, s.plants, s.missing_found, s.missing);
    all.add(s);
  }
  const auto share = [](int a, int b) { return 100.0 * a / std::max(b, 1); };
  printf(
      "%d rows: recall %.2f %%, precision %.2f %%; %d plants: %.2f %% in their row; %d strays: %.1f %% kept out; "
      "%d missing inside rows: %.2f %% found, %d listed\n",
      all.rows, share(all.matched, all.rows), share(all.matched, all.found), all.plants,
      share(all.assigned, all.plants), all.strays, share(all.strays_kept_out, all.strays), all.missing,
      share(all.missing_found, all.missing), all.missing_false);
  EXPECT_GE(share(all.matched, all.rows), 99);
  EXPECT_GE(share(all.matched, all.found), 99);
  EXPECT_GE(share(all.assigned, all.plants), 99);
  EXPECT_GE(share(all.missing_found, all.missing), 95);
}

// The same field turned, moved to projected coordinates and in another order has the same rows.
TEST(FindRows, TurnShiftAndOrderOfTheFileChangeNothingElse) {
  FieldMaker maker(5);
  maker.add_block({{0, 0}, 20 * rad_per_deg, 6, 20, 2, 4, 0});
  const auto field = maker.take();
  const auto first = find(field.table());
  ASSERT_EQ(first.rows.rows(), 6U);
  const Eigen::Rotation2Dd turn(33 * rad_per_deg);
  const Eigen::Vector2d shift(38'433'100.25, 2'562'040.5);
  std::vector<Eigen::Vector2d> moved;
  for (const auto& p : field.plants) moved.push_back(turn * p.at + shift);
  std::reverse(moved.begin(), moved.end());
  RowOptions options;
  options.fit = LineFitMethod::orthogonal;
  const auto a = find(field.table(), options), b = find(table_of(moved), options);
  ASSERT_EQ(b.rows.rows(), 6U);
  EXPECT_EQ(a.rows.integers("plants"), b.rows.integers("plants"));
  EXPECT_EQ(a.rows.integers("missing"), b.rows.integers("missing"));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(b.rows.numbers("angle_deg")[i] - a.rows.numbers("angle_deg")[i], 33, 1e-4);
    const Eigen::Vector2d end(a.rows.numbers("x0_m")[i], a.rows.numbers("y0_m")[i]);
    const Eigen::Vector2d there(b.rows.numbers("x0_m")[i], b.rows.numbers("y0_m")[i]);
    EXPECT_LT((turn * end + shift - there).norm(), 1e-4);
    EXPECT_NEAR(b.rows.numbers("spacing_m")[i], a.rows.numbers("spacing_m")[i], 1e-5);
  }
}

TEST(FindRows, RowsAreNumberedFromLeftToRightAndPlantsFromTheWest) {
  FieldMaker maker(9);
  BlockRecipe b{{0, 0}, 10 * rad_per_deg, 5, 12, 1.5, 3, 0};
  b.missing_share = 0;
  b.gap_share = 0;
  maker.add_block(b);
  const auto found = find(maker.take().table());
  ASSERT_EQ(found.rows.rows(), 5U);
  EXPECT_EQ(found.rows.integers("row_id"), (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  const auto y0 = found.rows.numbers("y0_m"), x0 = found.rows.numbers("x0_m"), x1 = found.rows.numbers("x1_m");
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LT(x0[i], x1[i]);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_LT(y0[i], y0[i - 1]);
  EXPECT_NEAR(found.report.metrics.at("row_spacing").value, 3, 0.05);
  EXPECT_NEAR(found.report.metrics.at("plant_spacing").value, 1.5, 0.03);
}

// The stated standard error is that of repeated plantings.
TEST(FindRows, TheStandardErrorOfTheAngleIsHonest) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 0.05);
  double square_sum = 0, predicted = 0;
  constexpr int trials = 400;
  for (int k = 0; k < trials; ++k) {
    Points2 row;
    for (int i = 0; i < 12; ++i) row.emplace_back(i + noise(random), noise(random));
    const auto fit = fit_least_squares(row);
    square_sum += fit.angle_rad * fit.angle_rad / trials;
    predicted += fit.angle_se_rad * fit.angle_se_rad / trials;
    EXPECT_NEAR(fit_orthogonal(row).angle_rad, fit.angle_rad, 1e-3);
  }
  EXPECT_NEAR(square_sum / predicted, 1, 0.2);
}

TEST(FindRows, NorthwardRowsHaveAnAngle) {
  const Points2 north{{1, 0}, {1, 1}, {1, 2}}, almost{{0, 0}, {-0.001, 1}, {0, 2}, {0.002, 3}};
  EXPECT_NEAR(fit_least_squares(north).angle_rad, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(row_angle_difference(fit_least_squares(almost).angle_rad, std::numbers::pi / 2), 0, 2e-3);
  EXPECT_EQ(row_angle(-std::numbers::pi / 2), std::numbers::pi / 2);
}

TEST(FindRows, NoRowsInAWrongDirectionSaysSo) {
  const auto table = table_of(trials()[1].left);
  EXPECT_EQ(find(table).report.counts.at("rows"), 1);
  RowOptions across;
  across.direction_deg = 90;
  const auto none = find(table, across);
  EXPECT_EQ(none.report.counts.at("rows"), 0);
  ASSERT_FALSE(none.report.warnings.empty());
  EXPECT_THAT(none.report.warnings.back(), HasSubstr("leave direction open"));
}

TEST(FindRows, ARowIdColumnFixesTheAssignment) {
  Table t = table_of({{0, 0}, {1, 0.1}, {2, -0.1}, {0, 2}, {5, 5}, {1, 2}, {9, 9}});
  t.set("row_id", std::vector<double>{7, 7, 7, 3, std::nan(""), 3, 11});
  t.set("tree_id", std::vector<std::int64_t>{10, 11, 12, 13, 14, 15, 16});
  const auto found = find(t);
  EXPECT_EQ(found.rows.integers("row_id"), (std::vector<std::int64_t>{3, 7, 11}));
  EXPECT_EQ(found.rows.integers("plants"), (std::vector<std::int64_t>{2, 3, 1}));
  EXPECT_TRUE(std::isnan(found.rows.numbers("angle_deg")[2]));
  EXPECT_TRUE(std::isnan(found.rows.numbers("angle_se_deg")[0]));
  ASSERT_EQ(found.strays.rows(), 1U);
  EXPECT_EQ(found.strays.texts("tree_id")[0], "14");
  Table named = table_of({{0, 0}, {1, 0}, {0, 2}, {1, 2}});
  named.set("row_id", std::vector<std::string>{"west", "west", "east", "east"});
  EXPECT_EQ(find(named).rows.texts("row_id"), (std::vector<std::string>{"east", "west"}));
}

TEST(FindRows, BadTablesAreRefusedAndOddOnesSurvive) {
  Table none;
  none.set("x_m", std::vector<double>{1});
  EXPECT_THROW(find(none), Error);
  EXPECT_THROW(find(table_of({{std::nan(""), 0}})), Error);
  for (const auto& points : {std::vector<Eigen::Vector2d>{{1, 1}},
                             {{1, 1}, {2, 2}},
                             {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {1e6, -1e6}},
                             {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1e-9, 1e-9}}}) {
    const auto found = find(table_of(points));
    EXPECT_EQ(found.report.counts.at("plants") + found.report.counts.at("strays"), std::ssize(points));
  }
  EXPECT_THROW(find(table_of({{0, 0}, {1, 0}, {2, 0}, {1e300, 0}})), Error);
  Table fraction = table_of({{0, 0}, {1, 0}});
  fraction.set("row_id", std::vector<double>{1, 1.5});
  try {
    find(fraction);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("row_id 1.5"));
  }
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(find_rows(mixed_field(1).table(), {}, run), Error);
}

}  // namespace
}  // namespace bole::rows
