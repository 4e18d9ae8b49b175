#include "stems/core/project_priors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "stems/core/circle_fit.h"

namespace bole {
namespace {

// Grids of standard deviations in metres. Poses wander by little between views of one pass.
constexpr std::array pass_sds{0.0005, 0.001, 0.002, 0.003, 0.0045, 0.0065, 0.01, 0.015, 0.02, 0.03, 0.05};
constexpr std::array view_sds{0.0005, 0.001, 0.0015, 0.002, 0.003, 0.0045, 0.0065, 0.01};

}  // namespace

DriftPrior likeliest_drift(const std::vector<const DriftEvidence*>& stems) {
  // A stem can say at most this much against a prior, so that few wild ones do not decide for all.
  constexpr double most_against = 10;
  std::array<double, pass_sds.size() * view_sds.size()> sum{}, own{};
  for (const auto* e : stems) {
    for (std::size_t k = 0; k < own.size(); ++k)
      own[k] = drift_log_likelihood(*e, {pass_sds[k / view_sds.size()], view_sds[k % view_sds.size()]});
    const double best = *std::ranges::max_element(own);
    for (std::size_t k = 0; k < own.size(); ++k) sum[k] += std::max(own[k] - best, -most_against);
  }
  const auto k = static_cast<std::size_t>(std::ranges::max_element(sum) - sum.begin());
  return {pass_sds[k / view_sds.size()], view_sds[k % view_sds.size()]};
}

RangeOffsetPrior mean_range_offset(std::vector<RangeOffsetEvidence> stems, double expected_sd_m) {
  // Stems share the lasers that meet them at breast height and the model of the beam: no number of stems averages
  // these out.
  constexpr double between_m = 0.003, shared_m = 0.0005, least_spread_m = 0.0005, weak_m = 0.05, freedom = 3;
  double mean = 0, variance = weak_m * weak_m;
  for (int round = 0; round < 10; ++round) {
    double weight = 1 / (weak_m * weak_m), moment = 0;
    for (const auto& e : stems) {
      const double v = e.sd_m * e.sd_m + between_m * between_m;
      const double w = tukey_weight((e.value_m - mean) / std::sqrt(v)) / v;
      weight += w, moment += w * e.value_m;
    }
    mean = moment / weight, variance = 1 / weight + shared_m * shared_m;
  }
  double drawn = mean, precision = 1 / variance;
  for (int round = 0; round < 20; ++round) {
    const double expected = (freedom + 1) / (freedom * expected_sd_m * expected_sd_m + drawn * drawn);
    precision = 1 / variance + expected, drawn = mean / variance / precision;
  }
  return {drawn, std::hypot(std::sqrt(1 / precision), least_spread_m)};
}

}  // namespace bole
