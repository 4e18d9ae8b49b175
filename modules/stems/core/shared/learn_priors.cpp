#include "stems/core/shared/learn_priors.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/statistics.h"
#include "stems/core/fit/stem_quality.h"
#include "stems/core/sensor_facts.h"
#include "stems/core/shared/project_priors.h"
#include "stems/core/shared/range_stretch.h"

namespace bole::stems {
namespace {

constexpr double all_round_rad = 6.0;

// Rays that all come from one side cannot tell their offset from the place of the stem.
bool tells_range_offset(const Stem& s) { return s.range_offset.sd_m > 0 && s.arc_rad > all_round_rad; }

void tell_priors(const ProjectPriors& priors, double moved_m, Report& report, bool drift, bool range_offset) {
  if (drift) {
    report.metrics["drift_between_passes"] = {100 * std::hypot(priors.drift.pass_sd_m, moved_m), Unit::centimetre};
    report.metrics["drift_between_views"] = {100 * priors.drift.view_sd_m, Unit::centimetre};
  }
  if (range_offset) report.metrics["range_offset"] = {100 * priors.range_offset.mean_m, Unit::centimetre};
}

}  // namespace

bool tells_range_stretch(const Stem& s) { return s.range_stretch.sd > 0 && s.arc_rad > all_round_rad; }

void learn_priors(const std::vector<Stem>& fitted, const MeasureOptions& options, double moved_m, ProjectPriors& priors,
                  Report& report, const Run& run) {
  std::vector<const DriftEvidence*> drift;
  std::vector<RangeOffsetEvidence> offsets;
  for (const auto& s : fitted) {
    if (objection(s, options)) continue;
    if (s.drift.target.size() > 0) drift.push_back(&s.drift);
    if (tells_range_offset(s)) offsets.push_back(s.range_offset);
  }
  const bool tells_offset = !offsets.empty() && options.estimate_range_offset;
  priors.learnt = !drift.empty() || !offsets.empty();
  if (!drift.empty()) priors.drift = mean_drift(drift, run);
  if (tells_offset)
    priors.range_offset = mean_range_offset(offsets, options.range_offset_sd.value_or(range_offset_of_many_lasers),
                                            priors.drift.view_sd_m);
  tell_priors(priors, moved_m, report, !drift.empty(), tells_offset);
}

void take_pooled(const PooledPriors& pooled, const MeasureOptions& options, double moved_m, ProjectPriors& priors,
                 Report& report) {
  const bool takes_offset = pooled.range_offset && options.estimate_range_offset;
  if (pooled.drift) priors.drift = *pooled.drift;
  if (takes_offset) priors.range_offset = *pooled.range_offset;
  tell_priors(priors, moved_m, report, pooled.drift.has_value(), takes_offset);
  priors.learnt = pooled.drift || pooled.range_offset;
  if (pooled.drift && pooled.drift->pass_sd_m >= min_drift_to_align_m)
    report.find(Severity::look, "passes_not_aligned",
                fmt::format("passes of the walk disagree by {:.1f} cm. In a part of a cloud they are not brought "
                            "together: diameters are of all passes as they lie",
                            100 * pooled.drift->pass_sd_m));
}

std::vector<StemEvidence> evidence_of(const std::vector<Stem>& fitted, const MeasureOptions& options,
                                      const Eigen::Vector3d& origin) {
  std::vector<StemEvidence> out;
  for (const auto& s : fitted) {
    if (objection(s, options)) continue;
    auto& e = out.emplace_back();
    e.at = (origin + s.breast_height).head<2>();
    if (s.drift.target.size() > 0) e.drift = drift_likelihoods(s.drift);
    if (tells_range_offset(s)) e.range_offset = s.range_offset;
    if (tells_range_stretch(s)) e.range_stretch = s.range_stretch;
    e.range_offset_expected_m = options.range_offset_sd.value_or(range_offset_of_many_lasers);
    if (s.along_rays) e.noise_m = s.noise_m, e.blur_m = s.blur_m;
  }
  return out;
}

std::optional<double> seen_noise_m(const std::vector<Stem>& fitted, const MeasureOptions& options) {
  std::vector<double> noise;
  for (const auto& s : fitted)
    if (s.along_rays && !objection(s, options)) noise.push_back(s.noise_m);
  if (noise.empty()) return std::nullopt;
  return upper_median(std::move(noise));
}

BlurPrior seen_blur(const std::vector<Stem>& fitted, const MeasureOptions& options) {
  std::vector<double> blurs;
  for (const auto& s : fitted)
    if (std::isfinite(s.blur_m) && !objection(s, options)) blurs.push_back(s.blur_m);
  return mean_blur(std::move(blurs));
}

RangeStretchPrior learn_range_stretch(const std::vector<Stem>& fitted, const MeasureOptions& options,
                                      double taken_out) {
  std::vector<RangeStretchEvidence> evidence;
  for (const auto& s : fitted)
    if (tells_range_stretch(s) && !objection(s, options)) {
      evidence.push_back(s.range_stretch);
      evidence.back().value += taken_out;
    }
  return mean_range_stretch(evidence);
}

std::vector<Eigen::Vector2d> stretched_stems(const std::vector<Stem>& fitted, const MeasureOptions& options,
                                             const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector2d> out;
  for (const auto& s : fitted)
    if (tells_range_stretch(s) && !objection(s, options)) out.push_back((origin + s.breast_height).head<2>());
  return out;
}

}  // namespace bole::stems
