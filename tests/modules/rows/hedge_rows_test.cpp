#include "rows/core/rows/hedge_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/angles.h"
#include "base/error.h"
#include "rows/core/rows/find_rows.h"

namespace bole::rows {
namespace {

// Hedges 3 m apart, 40 m long, half a metre thick, with clumps that stand out to one side and a gap in the second.
PointCloud hedges(double angle_deg, int rows, double bend_m = 0, unsigned seed = 1,
                  Eigen::Vector3d origin = {0, 0, 0}) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> off(0, 0.15);
  std::uniform_real_distribution<double> unit(0, 1);
  const Eigen::Vector2d u(std::cos(angle_deg * rad_per_deg), std::sin(angle_deg * rad_per_deg)), left(-u.y(), u.x());
  PointCloud::Positions points;
  for (int r = 0; r < rows; ++r)
    for (int i = 0; i < 6000; ++i) {
      const double along = 40 * unit(random), bend = bend_m * 4 * (along / 40) * (1 - along / 40);
      if (r == 1 && along > 20 && along < 24) continue;
      const double clump = std::fmod(along, 7.0) < 0.7 && unit(random) < 0.4 ? 0.5 + 0.3 * unit(random) : 0;
      const Eigen::Vector2d p = along * u + (3.0 * r + bend + off(random) + clump) * left;
      points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(2 * unit(random)));
    }
  return PointCloud(std::move(points), origin);
}

std::vector<double> angle_errors(const Table& stems, double angle_deg) {
  std::vector<double> errors;
  for (const double a : find_rows(stems, {}, bole::Run{}).rows.numbers("angle_deg"))
    errors.push_back(std::abs(std::remainder(a - angle_deg, 180.0)));
  return errors;
}

TEST(HedgeRows, FindsDirectionAndRowsWhateverTheirDirection) {
  for (const double angle : {-88.0, -41.5, 0.0, 17.3, 63.0, 90.0}) {
    Report report;
    const auto stems = hedge_rows(hedges(angle, 4), {}, bole::Run{}, report);
    EXPECT_EQ(report.counts.at("rows"), 4) << angle;
    EXPECT_NEAR(std::remainder(report.metrics.at("direction").value - angle, 180.0), 0, 1) << angle;
    const auto errors = angle_errors(stems, angle);
    ASSERT_EQ(errors.size(), 4U) << angle;
    EXPECT_LT(*std::ranges::max_element(errors), 0.15) << angle;
  }
}

TEST(HedgeRows, OneRowAloneIsFound) {
  Report report;
  const auto stems = hedge_rows(hedges(30, 1), {}, bole::Run{}, report);
  EXPECT_EQ(report.counts.at("rows"), 1);
  EXPECT_LT(angle_errors(stems, 30).at(0), 0.15);
}

TEST(HedgeRows, GapsHaveNoPointsAndBentRowsAreFollowed) {
  Report report;
  HedgeOptions o;
  o.direction_deg = 0;
  const auto stems = hedge_rows(hedges(0, 3, 2.0), o, bole::Run{}, report);
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  ASSERT_EQ(report.counts.at("rows"), 3);
  double square_sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double row = 3.0 * (3 - static_cast<double>(stems.integers("row_id")[i]));
    square_sum += std::pow(y[i] - row - 8 * (x[i] / 40) * (1 - x[i] / 40), 2);
    EXPECT_FALSE(row == 3.0 && x[i] > 20.1 && x[i] < 23.9) << x[i];
  }
  EXPECT_LT(std::sqrt(square_sum / static_cast<double>(x.size())), 0.12);  // a clump moves the point of its piece
  EXPECT_GT(x.size(), 3 * 80 - 12);
  // The course of the middle row is a curve whose sagitta is the bend.
  const auto found = find_rows(stems, {}, bole::Run{});
  EXPECT_EQ(found.rows.texts("shape")[1], "curved");
  EXPECT_NEAR(found.rows.numbers("sagitta_m")[1], 2.0, 0.1);
}

TEST(HedgeRows, FarFromTheOriginNothingChanges) {
  Report report;
  const Eigen::Vector3d utm(500'000, 4'600'000, 0);
  const auto near = hedge_rows(hedges(17, 3), {}, bole::Run{}, report),
             far = hedge_rows(hedges(17, 3, 0, 1, utm), {}, bole::Run{}, report);
  ASSERT_EQ(near.rows(), far.rows());
  for (std::size_t i = 0; i < near.rows(); ++i)
    EXPECT_NEAR(far.numbers("x_m")[i] - utm.x(), near.numbers("x_m")[i], 1e-5);
}

TEST(HedgeRows, TheReferenceSystemOfTheCloudGoesWithTheRows) {
  Report report;
  auto canopy = hedges(0, 2);
  canopy.axes = Axes::global;
  canopy.crs_wkt = "PROJCS[...]";
  const auto found = find_rows(hedge_rows(canopy, {}, bole::Run{}, report), {}, bole::Run{});
  for (const Table* t : {&found.rows, &found.lines, &found.plants}) {
    EXPECT_EQ(t->facts.at("crs"), "PROJCS[...]");
    EXPECT_EQ(t->facts.at("axes"), "global");
  }
}

TEST(HedgeRows, RefusesWhatIsNoField) {
  Report report;
  EXPECT_THROW(hedge_rows(PointCloud(), {}, bole::Run{}, report), Error);
  EXPECT_THROW(hedge_rows(PointCloud(PointCloud::Positions{{0, 0, 0}, {5e5F, 0, 0}}), {}, bole::Run{}, report), Error);
  EXPECT_THROW(hedge_rows(PointCloud(PointCloud::Positions{{std::nanf(""), 0, 0}}), {}, bole::Run{}, report), Error);
  EXPECT_EQ(hedge_rows(PointCloud(PointCloud::Positions{{0, 0, 0}}), {}, bole::Run{}, report).rows(), 0U);
}

}  // namespace
}  // namespace bole::rows
