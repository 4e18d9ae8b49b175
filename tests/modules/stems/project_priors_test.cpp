#include "stems/core/shared/project_priors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bole::stems {
namespace {

// Steps of the grids in project_priors.cpp: passes 4.5 and 6.5 mm, views 4.5 and 6.5 mm.
constexpr std::size_t pass_45 = 4, pass_65 = 5, view_45 = 5, view_65 = 6;

std::size_t at(std::size_t pass, std::size_t view) { return pass * drift_view_steps + view; }

DriftLikelihoods unlikely() {
  DriftLikelihoods sum;
  sum.fill(-1000);
  return sum;
}

TEST(MeanDrift, IsTheStepThatAllStemsSpeakFor) {
  auto sum = unlikely();
  sum[at(pass_45, view_65)] = -500;
  const auto drift = mean_drift(sum);
  EXPECT_NEAR(drift.pass_sd_m, 0.0045, 1e-9);
  EXPECT_NEAR(drift.view_sd_m, 0.0065, 1e-9);
}

TEST(MeanDrift, DoesNotLeapBetweenStepsThatAreAsGood) {
  auto sum = unlikely();
  sum[at(pass_45, view_65)] = sum[at(pass_65, view_45)] = 0;
  const auto between = std::sqrt((0.0045 * 0.0045 + 0.0065 * 0.0065) / 2);
  EXPECT_NEAR(mean_drift(sum).pass_sd_m, between, 1e-9);
  sum[at(pass_45, view_65)] = -0.1;
  EXPECT_NEAR(mean_drift(sum).pass_sd_m, between, 1e-4);
  EXPECT_NEAR(mean_drift(sum).view_sd_m, between, 1e-4);
}

}  // namespace
}  // namespace bole::stems
