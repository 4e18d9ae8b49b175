#include "evaluation/core/error_measures.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "evaluation/core/published.h"

namespace bole::evaluation {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ErrorMeasures, PositionsByHand) {
  // Errors (3, 0), (-1, 2), (1, 1) cm: mean (1, 1); about it (2, -1), (-2, 1), (0, 0).
  const auto m = position_measures({{0.03, 0}, {-0.01, 0.02}, {0.01, 0.01}});
  EXPECT_EQ(m.n, 3U);
  EXPECT_NEAR(m.mean.x(), 0.01, 1e-12);
  EXPECT_NEAR(m.mean.y(), 0.01, 1e-12);
  EXPECT_NEAR(m.covariance(0, 0), 8e-4 / 3, 1e-12) << "divided by n";
  EXPECT_NEAR(m.covariance(0, 1), -4e-4 / 3, 1e-12);
  EXPECT_NEAR(m.sigma.y(), std::sqrt(2e-4 / 3), 1e-12);
  EXPECT_NEAR(m.correlation, -1, 1e-9) << "both errors lie on one line";
  EXPECT_NEAR(m.max_sigma, std::sqrt(10e-4 / 3), 1e-12) << "all of the variance lies along that line";
  EXPECT_NEAR(m.rmse.x(), std::sqrt((9e-4 + 1e-4 + 1e-4) / 3), 1e-12);
  EXPECT_NEAR(m.rmse.y(), std::sqrt((0 + 4e-4 + 1e-4) / 3), 1e-12);
}

TEST(ErrorMeasures, NoErrorsAreNoZeros) {
  const auto m = position_measures({});
  EXPECT_EQ(m.n, 0U);
  EXPECT_TRUE(std::isnan(m.max_sigma) && std::isnan(m.rmse.x()) && std::isnan(m.mean.y()));
  const auto d = diameter_measures({});
  EXPECT_TRUE(std::isnan(d.bias_cm) && std::isnan(d.relative_rmse_pct) && std::isnan(d.coverage_pct));
}

// relBIAS is the mean of the relative errors: +10 % and -5 % give +2.5 %. BIAS by the mean diameter would give 0 %.
TEST(ErrorMeasures, RelativeErrorsAreMeansOfRelativeErrors) {
  const auto m = diameter_measures({{11, 10, nan, nan}, {19, 20, nan, nan}});
  EXPECT_NEAR(m.bias_cm, 0, 1e-12);
  EXPECT_NEAR(m.relative_bias_pct, 2.5, 1e-12);
  EXPECT_NEAR(m.rmse_cm, 1, 1e-12);
  EXPECT_NEAR(m.relative_rmse_pct, 100 * std::sqrt((0.01 + 0.0025) / 2), 1e-9);
}

TEST(ErrorMeasures, PairsWithoutADiameterTakeNoPart) {
  const auto m =
      diameter_measures({{11, 10, 9, 12}, {nan, 20, nan, nan}, {20, nan, 19, 21}, {15, 0, 10, 20}, {22, 20, 20.5, 23}});
  EXPECT_EQ(m.n, 2U);
  EXPECT_NEAR(m.bias_cm, 1.5, 1e-12);
  EXPECT_EQ(m.with_interval, 2U);
  EXPECT_NEAR(m.coverage_pct, 50, 1e-12);
}

TEST(Published, BothSystemsOfThePaper) {
  EXPECT_EQ(published_figure(PublishedPlot::plot2, PaperSystem::improved_loam, "dbh_rmse"), "1.07");
  EXPECT_EQ(published_figure(PublishedPlot::plot2, PaperSystem::loam, "dbh_rmse"), "3.69");
  EXPECT_EQ(published_figure(PublishedPlot::overall, PaperSystem::loam, "position_mean_x"), "-0.040");
  EXPECT_EQ(published_figure(PublishedPlot::none, PaperSystem::loam, "dbh_rmse"), "");
  EXPECT_EQ(published_figure(PublishedPlot::plot1, PaperSystem::loam, "completeness"), "");
}

TEST(Published, PresetsAndPlotsByTheirNames) {
  EXPECT_EQ(paper_system("loam"), PaperSystem::loam);
  EXPECT_EQ(paper_system("loam_paper"), PaperSystem::loam);
  EXPECT_EQ(paper_system("forest"), PaperSystem::improved_loam);
  EXPECT_EQ(paper_system("forest_paper"), PaperSystem::improved_loam);
  for (const char* other : {"best", "orchard", "lego_loam", "given poses", ""})
    EXPECT_FALSE(paper_system(other)) << other;
  EXPECT_EQ(published_plot_named("plot3"), PublishedPlot::plot3);
  EXPECT_EQ(published_plot_named("4"), PublishedPlot::plot4);
  EXPECT_EQ(published_plot_named("plot 1"), PublishedPlot::plot1);
  for (const char* other : {"plot5", "plot", "stand 1", "plot1-2", ""})
    EXPECT_EQ(published_plot_named(other), PublishedPlot::none) << other;
}

// BIAS by the mean diameter of the plot cannot give the printed relBIAS of plots 3 and 4, whatever the rounding.
TEST(Published, ExcludesTheOtherDefinitionOfRelBias) {
  const auto least_possible = [](double bias_cm, double mean_cm) {
    return 100 * (std::abs(bias_cm) + 0.005) / mean_cm;
  };
  EXPECT_LT(least_possible(0.28, 16.86), 1.885);
  EXPECT_LT(least_possible(-0.08, 18.25), 0.585);
}

}  // namespace
}  // namespace bole::evaluation
