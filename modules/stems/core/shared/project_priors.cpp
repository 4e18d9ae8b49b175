#include "stems/core/shared/project_priors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.h"
#include "stems/core/shared/drawn_mean.h"

namespace bole::stems {
namespace {

// Grids of standard deviations in metres. Poses wander by little between views of one pass.
constexpr std::array<double, drift_pass_steps> pass_sds{0.0005, 0.001, 0.002, 0.003, 0.0045, 0.0065,
                                                        0.01,   0.015, 0.02,  0.03,  0.05};
constexpr std::array<double, drift_view_steps> view_sds{0.0005, 0.001, 0.0015, 0.002, 0.003, 0.0045, 0.0065, 0.01};

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

// Weighted by the likelihood: the mode would leap between two steps that are as good, of which one gives to the passes
// what the other gives to the views.
DriftPrior mean_drift(const DriftLikelihoods& sum) {
  const double best = *std::ranges::max_element(sum);
  double weights = 0, pass2 = 0, view2 = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double weight = std::exp(sum[k] - best), pass = pass_sds[k / view_sds.size()],
                 view = view_sds[k % view_sds.size()];
    weights += weight, pass2 += weight * pass * pass, view2 += weight * view * view;
  }
  return {std::sqrt(pass2 / weights), std::sqrt(view2 / weights)};
}

DriftPrior mean_drift(const std::vector<const DriftEvidence*>& stems, const Run& run) {
  std::vector<DriftLikelihoods> of_stem(stems.size());
  tbb::parallel_for(std::size_t{0}, stems.size(), [&](std::size_t i) {
    if (!run.cancelled()) of_stem[i] = drift_likelihoods(*stems[i]);
  });
  run.check_cancel();
  DriftLikelihoods sum{};
  for (const auto& own : of_stem)
    for (std::size_t k = 0; k < own.size(); ++k) sum[k] += own[k];
  return mean_drift(sum);
}

RangeOffsetPrior mean_range_offset(const std::vector<RangeOffsetEvidence>& stems, double expected_sd_m,
                                   double view_sd_m) {
  // What stems say of the offset is how strongly their bark seems to curve against where it lies, so an error of shape
  // that all share comes out threefold, and no number of stems averages it out: on maps with true poses (views apart by
  // 0.5 to 1.5 mm) the mean was right to 1 mm, on SLAM maps without an inertial unit (2 to 3 mm) it was 4 to 5 mm too
  // low.
  constexpr double between_m = 0.003, shape_m = 0.001, by_view = 1.3, min_spread_m = 0.0005, weak_m = 0.05;
  std::vector<SharedEvidence> values;
  for (const auto& e : stems) values.push_back({e.value_m, e.sd_m, e.beam_doubt_m});
  const auto mean = bounded_mean(values, between_m, std::hypot(shape_m, by_view * view_sd_m), weak_m);
  const auto drawn = drawn_to_zero(mean, expected_sd_m);
  return {drawn.mean, std::hypot(drawn.sd, min_spread_m)};
}

BlurPrior mean_blur(std::vector<double> blurs_m) {
  constexpr double min_blur_m = 0.006;
  if (blurs_m.empty()) return {};
  BlurPrior out;
  out.mean_m = upper_median(blurs_m);
  if (out.mean_m < min_blur_m) return {};
  for (auto& b : blurs_m) b = std::abs(b - out.mean_m);
  const double spread = 1.4826 * upper_median(std::move(blurs_m)), own = blur_error_of_stem * out.mean_m;
  out.between_m = std::sqrt(std::max(0.0, spread * spread - own * own));
  return out;
}

}  // namespace bole::stems
