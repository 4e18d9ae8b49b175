#include "stems/core/fit/project_priors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

// Grids of standard deviations in metres. Poses wander by little between views of one pass.
constexpr std::array<double, drift_pass_steps> pass_sds{0.0005, 0.001, 0.002, 0.003, 0.0045, 0.0065,
                                                        0.01,   0.015, 0.02,  0.03,  0.05};
constexpr std::array<double, drift_view_steps> view_sds{0.0005, 0.001, 0.0015, 0.002, 0.003, 0.0045, 0.0065, 0.01};

// Mean and spread of the offset under a normal likelihood and the prior of mean_range_offset, by quadrature: the mode
// would leap between zero and the evidence.
RangeOffsetPrior drawn_to_zero(double mean_m, double variance_m2, double expected_sd_m, double min_spread_m) {
  constexpr int steps = 2000;
  constexpr double freedom = 3;
  const double reach = std::abs(mean_m) + 6 * std::sqrt(variance_m2);
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = reach * (2.0 * i / steps - 1), u = x / expected_sd_m;
    const double w =
        std::exp(-0.5 * (x - mean_m) * (x - mean_m) / variance_m2) * std::pow(1 + u * u / freedom, -(freedom + 1) / 2);
    sum += w, first += w * x, second += w * x * x;
  }
  const double drawn = first / sum;
  return {drawn, std::hypot(std::sqrt(std::max(0.0, second / sum - drawn * drawn)), min_spread_m)};
}

}  // namespace

DriftLikelihoods drift_likelihoods(const DriftEvidence& stem) {
  // A stem can say at most this much against a prior, so that few wild ones do not decide for all.
  constexpr double max_against = 10;
  DriftLikelihoods out;
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = drift_log_likelihood(stem, {pass_sds[k / view_sds.size()], view_sds[k % view_sds.size()]});
  const double best = *std::ranges::max_element(out);
  for (double& v : out) v = std::max(v - best, -max_against);
  return out;
}

DriftPrior likeliest_drift(const DriftLikelihoods& sum) {
  const auto k = static_cast<std::size_t>(std::ranges::max_element(sum) - sum.begin());
  return {pass_sds[k / view_sds.size()], view_sds[k % view_sds.size()]};
}

DriftPrior likeliest_drift(const std::vector<const DriftEvidence*>& stems, const Run& run) {
  std::vector<DriftLikelihoods> of_stem(stems.size());
  tbb::parallel_for(std::size_t{0}, stems.size(), [&](std::size_t i) {
    if (!run.cancelled()) of_stem[i] = drift_likelihoods(*stems[i]);
  });
  run.check_cancel();
  DriftLikelihoods sum{};
  for (const auto& own : of_stem)
    for (std::size_t k = 0; k < own.size(); ++k) sum[k] += own[k];
  return likeliest_drift(sum);
}

RangeOffsetPrior mean_range_offset(const std::vector<RangeOffsetEvidence>& stems, double expected_sd_m,
                                   double view_sd_m) {
  // What stems say of the offset is how strongly their bark seems to curve against where it lies, so an error of shape
  // that all share comes out threefold, and no number of stems averages it out: on maps with true poses (views apart by
  // 0.5 to 1.5 mm) the mean was right to 1 mm, on SLAM maps without an inertial unit (2 to 3 mm) it was 4 to 5 mm too
  // low.
  constexpr double between_m = 0.003, shape_m = 0.001, by_view = 1.3, min_spread_m = 0.0005, weak_m = 0.05;
  std::vector<double> values, doubts;
  for (const auto& e : stems) values.push_back(e.value_m), doubts.push_back(e.beam_doubt_m);
  const double shared_m = std::hypot(shape_m, by_view * view_sd_m, doubts.empty() ? 0 : upper_median(doubts));
  double mean = values.empty() ? 0 : upper_median(values), variance = weak_m * weak_m;
  for (int round = 0; round < 10; ++round) {
    double weight = 1 / (weak_m * weak_m), moment = 0;
    for (const auto& e : stems) {
      const double v = e.sd_m * e.sd_m + between_m * between_m;
      const double w = tukey_weight((e.value_m - mean) / std::sqrt(v)) / v;
      weight += w, moment += w * e.value_m;
    }
    mean = moment / weight, variance = 1 / weight + shared_m * shared_m;
  }
  return drawn_to_zero(mean, variance, expected_sd_m, min_spread_m);
}

}  // namespace bole::stems
