#include "inventory/core/sample_plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random.h"

namespace bole::inventory {
namespace {

using ::testing::HasSubstr;

// Trees at random in a square of 100 m about `centre`, turned by `bearing`.
Table stand(int trees, std::uint64_t seed, const Eigen::Vector2d& centre = {0, 0}, double bearing = 0) {
  Random random(seed, 1);
  std::vector<double> x, y, dbh;
  for (int i = 0; i < trees; ++i) {
    const double u = random.uniform(-50, 50), v = random.uniform(-50, 50);
    const Eigen::Vector2d p = Eigen::Rotation2Dd(-bearing) * Eigen::Vector2d(u, v) + centre;
    x.push_back(p.x());
    y.push_back(p.y());
    dbh.push_back(random.uniform(10, 40));
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("dbh_cm", dbh);
  return t;
}

const CountingRule square{rectangle_area({0, 0}, 100, 100), 7};

double value_of_edge(const SampleStudy& s, const std::string& edge, const char* column) {
  const auto& edges = s.summary.texts("edge");
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i] == edge) return s.summary.numbers(column)[i];
  return NAN;
}

SampleOptions with(const char* radii, int plots) {
  SampleOptions o;
  o.radii = radii;
  o.plots = plots;
  return o;
}

TEST(CircleInRectangle, IsTheAreaThatCountingFinds) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(circle_in_rectangle_m2({0, 0}, 5, 20, 30), 25 * pi, 1e-9);
  EXPECT_NEAR(circle_in_rectangle_m2({10, 0}, 5, 20, 30), 12.5 * pi, 1e-9);
  EXPECT_NEAR(circle_in_rectangle_m2({10, -15}, 5, 20, 30), 6.25 * pi, 1e-9);
  EXPECT_NEAR(circle_in_rectangle_m2({100, 0}, 5, 20, 30), 0, 1e-9);
  EXPECT_NEAR(circle_in_rectangle_m2({0, 0}, 100, 20, 30), 600, 1e-9);
  Random random(3, 1);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector2d c(random.uniform(-13, 13), random.uniform(-18, 18));
    const double r = random.uniform(1, 14), step = r / 400;
    double area = 0;
    for (double x = -r + step / 2; x < r; x += step)
      for (double y = -r + step / 2; y < r; y += step)
        area += x * x + y * y < r * r && std::abs(x + c.x()) < 10 && std::abs(y + c.y()) < 15 ? step * step : 0;
    EXPECT_NEAR(circle_in_rectangle_m2(c, r, 20, 30), area, 0.01 * r * r) << k;
  }
}

// Of trees at random: whoever ignores the edge misses the trees beyond it, the others are right on average.
TEST(SamplePlots, TheEdgeBiasesWhereItIsIgnored) {
  const auto study = sample_plots(stand(800, 5), square, with("12", 4000), {});
  const auto bias = [&](const char* edge) { return value_of_edge(study, edge, "stems_per_ha_bias_pct"); };
  const auto se = [&](const char* edge) { return value_of_edge(study, edge, "stems_per_ha_bias_se_pct"); };
  EXPECT_NEAR(value_of_edge(study, "ignore", "stems_per_ha_true"), 800, 1e-9);
  // On average 1 - (8 r / 3 pi) (1/a + 1/b) + ... of a plot lies inside a x b: 10 % is missing.
  const double r = 12,
               expected = 100 * (-2 * 4 * r / (3 * std::numbers::pi * 100) + r * r / (2 * std::numbers::pi * 1e4));
  EXPECT_NEAR(bias("ignore"), expected, 4 * se("ignore") + 2);  // the trees of one stand
  EXPECT_LT(bias("ignore"), -8);
  EXPECT_NEAR(bias("mirage"), 0, 4 * se("mirage"));
  EXPECT_NEAR(bias("area"), 0, 4 * se("area") + 1);
}

TEST(SamplePlots, ScatterFallsAsTheRootOfTheArea) {
  // Another stand for every plot would be Poisson exactly; in one stand of 2000 trees small plots are nearly so.
  const auto study = sample_plots(stand(2000, 8), square, with("3 6", 3000), {});
  const auto sd = study.summary.numbers("stems_per_ha_sd_pct"),
             poisson = study.summary.numbers("stems_per_ha_poisson_sd_pct");
  const auto& edge = study.summary.texts("edge");
  for (std::size_t i = 0; i < sd.size(); ++i)
    if (edge[i] == "inside") {
      EXPECT_NEAR(sd[i] / poisson[i], 1, 0.2) << i;
    }
}

TEST(SamplePlots, ErrorsOfDistancesBiasSmallPlotsMost) {
  auto o = with("4 12", 3000);
  o.distance_bias = -0.1;  // trees up to 10 cm beyond the boundary count
  const auto study = sample_plots(stand(2000, 2), square, o, {});
  const auto exact = sample_plots(stand(2000, 2), square, with("4 12", 3000), {});
  const auto& edge = study.summary.texts("edge");
  const auto a = study.summary.numbers("stems_per_ha_mean"), b = exact.summary.numbers("stems_per_ha_mean"),
             r = study.summary.numbers("radius_m");
  for (std::size_t i = 0; i < a.size(); ++i)
    if (edge[i] == "inside") {
      EXPECT_NEAR(a[i] / b[i], std::pow((r[i] + 0.1) / r[i], 2), 0.012) << i;
    }
}

// A stand that lies elsewhere and points elsewhere gives the same study.
TEST(SamplePlots, TurnWithTheStand) {
  const Eigen::Vector2d centre(500'000, 5'300'000);
  const CountingRule turned{rectangle_area(centre, 100, 100, 0.7), 7};
  const auto a = sample_plots(stand(300, 4), square, with("8", 200), {}),
             b = sample_plots(stand(300, 4, centre, 0.7), turned, with("8", 200), {});
  for (const char* column : {"stems_per_ha_mean", "basal_area_m2_per_ha_mean", "partial_pct"})
    for (std::size_t i = 0; i < a.summary.rows(); ++i)
      EXPECT_NEAR(a.summary.numbers(column)[i], b.summary.numbers(column)[i], 1e-6) << column << i;
}

TEST(SamplePlots, SaysWhatIsWrong) {
  const auto error_of = [](const Table& trees, const CountingRule& rule, const SampleOptions& o) {
    try {
      sample_plots(trees, rule, o, {});
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      return std::string(e.what());
    }
    return std::string("no error");
  };
  const auto trees = stand(50, 1);
  EXPECT_THAT(error_of(trees, {circle_area({0, 0}, 50), 7}, {}), HasSubstr("no rectangle"));
  EXPECT_THAT(error_of(trees, {rectangle_area({1000, 0}, 100, 100), 7}, {}), HasSubstr("none of 50 stems"));
  for (const char* radii : {"", "x", "0", "-3", "50", "nan"})
    EXPECT_THAT(error_of(trees, square, with(radii, 10)), HasSubstr("radi"));
}

}  // namespace
}  // namespace bole::inventory
