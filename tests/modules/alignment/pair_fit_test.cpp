#include "alignment/core/pair_fit.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "modules/alignment/small_stand.h"

namespace bole::alignment {
namespace {

const Eigen::Vector3d utm(563000, 5412000, 300);

// Pairs that a known motion makes; errors in metres on the fixed side.
std::vector<PointPair> known_pairs(const Similarity& truth, std::size_t count, double error_m, std::uint64_t seed) {
  Random random(seed, 1);
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d p = utm + Eigen::Vector3d(random.uniform(0, 30), random.uniform(0, 30), random.uniform(0, 8));
    pairs.push_back({p, truth.of(p) + error_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal())});
  }
  return pairs;
}

Similarity known_motion(double scale) {
  Similarity truth;
  truth.turn = rotation_from_rpy(0.02, -0.05, 2.4);
  truth.scale = scale;
  truth.from = utm + Eigen::Vector3d(3, 4, 5);
  truth.to = {1, 2, 0.5};
  return truth;
}

TEST(PairFit, FindsAKnownMotionFarFromTheOrigin) {
  for (const std::size_t count : {3u, 4u, 10u}) {
    const auto truth = known_motion(1);
    const auto pairs = known_pairs(truth, count, 0, 11 + count);
    const auto fit = fit_pairs(pairs, false);
    EXPECT_EQ(fit.motion.scale, 1);
    EXPECT_LT((fit.motion.turn - truth.turn).norm(), 1e-8) << count;
    for (const auto& pair : pairs) EXPECT_LT((fit.motion.of(pair.moved) - pair.fixed).norm(), 1e-6);
    EXPECT_LT(fit.rms_m, 1e-6);
  }
}

TEST(PairFit, FindsTheScaleOnlyWhereItIsAskedFor) {
  const auto truth = known_motion(1.03);
  const auto pairs = known_pairs(truth, 6, 0, 5);
  const auto scaled = fit_pairs(pairs, true);
  EXPECT_NEAR(scaled.motion.scale, 1.03, 1e-8);
  EXPECT_LT(scaled.rms_m, 1e-6);
  const auto rigid = fit_pairs(pairs, false);
  EXPECT_EQ(rigid.motion.scale, 1);
  EXPECT_NEAR(rigid.motion.turn.determinant(), 1, 1e-12);
  EXPECT_GT(rigid.rms_m, 0.1);
}

// The residuals of n pairs with errors of sigma have 3 n - 6 degrees of freedom.
TEST(PairFit, TellsTheErrorsOfTheClicks) {
  double squares = 0;
  constexpr int runs = 200;
  constexpr std::size_t count = 8;
  for (std::uint64_t run = 0; run < runs; ++run) {
    const auto fit = fit_pairs(known_pairs(known_motion(1), count, 0.03, 100 + run), false);
    double sum = 0;
    for (const double r : fit.residual_m) sum += r * r;
    EXPECT_NEAR(fit.rms_m, std::sqrt(sum / count), 1e-12);
    squares += sum / (3 * count - 6);
  }
  EXPECT_NEAR(std::sqrt(squares / runs), 0.03, 0.001);
}

TEST(PairFit, AWrongPairHasTheLargestResidual) {
  auto pairs = known_pairs(known_motion(1), 7, 0.01, 3);
  pairs[4].fixed += Eigen::Vector3d(0.6, -0.5, 0.1);
  const auto fit = fit_pairs(pairs, false);
  EXPECT_EQ(std::ranges::max_element(fit.residual_m) - fit.residual_m.begin(), 4);
  pairs.erase(pairs.begin() + 4);
  EXPECT_LT(fit_pairs(pairs, false).rms_m, 0.03);
}

TEST(PairFit, RefusesTooFewPairsAndPairsOnALine) {
  const auto truth = known_motion(1);
  auto pairs = known_pairs(truth, 2, 0, 1);
  EXPECT_EQ(problem_of(pairs), PairProblem::too_few);
  EXPECT_THROW(fit_pairs(pairs, false), Error);
  pairs.clear();
  for (const double along : {0.0, 4.0, 9.0, 15.0}) {
    const Eigen::Vector3d p =
        utm + along * Eigen::Vector3d(0.8, 0.55, 0.1) + Eigen::Vector3d(0, 0, 0.01 * along * along / 15);
    pairs.push_back({p, truth.of(p)});
  }
  EXPECT_EQ(problem_of(pairs), PairProblem::on_a_line);
  EXPECT_THROW(fit_pairs(pairs, false), Error);
  // One side is enough.
  pairs[2].moved += Eigen::Vector3d(-2, 3, 0);
  EXPECT_EQ(problem_of(pairs), PairProblem::on_a_line);
  pairs[2].fixed = truth.of(pairs[2].moved);
  EXPECT_EQ(problem_of(pairs), PairProblem::none);
  // The same place three times is no better.
  EXPECT_EQ(problem_of(std::vector<PointPair>(3, {utm, utm})), PairProblem::on_a_line);
}

}  // namespace
}  // namespace bole::alignment
