#include "stems/core/shared/pooled_priors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/error.h"
#include "base/no_number.h"
#include "base/statistics.h"
#include "stems/core/sensor_facts.h"
#include "stems/core/shared/range_stretch.h"

namespace bole::stems {
namespace {

std::string drift_column(std::size_t k) { return fmt::format("drift_{}", k); }

// A column of empty cells alone is read from a file as words.
std::vector<double> numbers_in(const Table& table, const std::string& name) {
  const auto* values = table.find(name);
  const auto* words = values == nullptr ? nullptr : std::get_if<std::vector<std::string>>(values);
  const bool nothing = words != nullptr && std::ranges::all_of(*words, [](const auto& w) { return w.empty(); });
  return nothing ? std::vector<double>(words->size(), no_number) : table.numbers(name);
}

// The only row of a table of priors.
double single(const Table& table, const char* name) {
  const auto values = numbers_in(table, name);
  if (values.size() != 1)
    throw bad_input(fmt::format("the table of priors has {} rows", values.size()), "one", "stems.pool_priors makes it");
  return values.front();
}

}  // namespace

PooledPriors pool(const std::vector<StemEvidence>& stems, std::optional<double> range_offset_sd_m) {
  PooledPriors out;
  DriftLikelihoods sum{};
  std::vector<RangeOffsetEvidence> offsets;
  std::vector<RangeStretchEvidence> stretches;
  std::vector<double> noise, expected, blurs;
  bool drifts = false;
  for (const auto& s : stems) {
    if (s.drift) {
      drifts = true;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += (*s.drift)[k];
    }
    if (s.range_offset.sd_m > 0) offsets.push_back(s.range_offset);
    if (s.range_stretch.sd > 0) stretches.push_back(s.range_stretch);
    if (s.noise_m > 0) noise.push_back(s.noise_m);
    if (std::isfinite(s.blur_m)) blurs.push_back(s.blur_m);
    if (s.range_offset_expected_m > 0) expected.push_back(s.range_offset_expected_m);
  }
  if (drifts) out.drift = mean_drift(sum);
  const double sd_m = expected.empty() ? range_offset_of_many_lasers : upper_median(std::move(expected));
  if (!offsets.empty())
    out.range_offset =
        mean_range_offset(offsets, range_offset_sd_m.value_or(sd_m), out.drift.value_or(DriftPrior{}).view_sd_m);
  if (!stretches.empty()) out.range_stretch = mean_range_stretch(stretches);
  if (!noise.empty()) out.noise_m = upper_median(std::move(noise));
  out.blur = mean_blur(std::move(blurs));
  return out;
}

Table evidence_table(const std::vector<StemEvidence>& stems) {
  Table t;
  const auto add = [&](const std::string& name, const auto& value) {
    std::vector<double> column;
    for (const auto& s : stems) column.push_back(value(s));
    t.set(name, std::move(column));
  };
  add("x_m", [](const StemEvidence& s) { return s.at.x(); });
  add("y_m", [](const StemEvidence& s) { return s.at.y(); });
  add("range_offset_m", [](const StemEvidence& s) { return s.range_offset.value_m; });
  add("range_offset_sd_m", [](const StemEvidence& s) { return s.range_offset.sd_m; });
  add("range_offset_beam_doubt_m", [](const StemEvidence& s) { return s.range_offset.beam_doubt_m; });
  add("range_stretch", [](const StemEvidence& s) { return s.range_stretch.value; });
  add("range_stretch_sd", [](const StemEvidence& s) { return s.range_stretch.sd; });
  add("range_stretch_doubt", [](const StemEvidence& s) { return s.range_stretch.doubt; });
  add("noise_m", [](const StemEvidence& s) { return s.noise_m; });
  add("blur_m", [](const StemEvidence& s) { return s.blur_m; });
  add("range_offset_expected_m", [](const StemEvidence& s) { return s.range_offset_expected_m; });
  for (std::size_t k = 0; k < DriftLikelihoods{}.size(); ++k)
    add(drift_column(k), [k](const StemEvidence& s) { return s.drift ? (*s.drift)[k] : no_number; });
  return t;
}

std::vector<StemEvidence> evidence_in(const Table& table) {
  const auto x = numbers_in(table, "x_m"), y = numbers_in(table, "y_m"), offset = numbers_in(table, "range_offset_m"),
             offset_sd = numbers_in(table, "range_offset_sd_m"), noise = numbers_in(table, "noise_m"),
             doubt = numbers_in(table, "range_offset_beam_doubt_m"),
             expected = numbers_in(table, "range_offset_expected_m"), stretch = numbers_in(table, "range_stretch"),
             stretch_sd = numbers_in(table, "range_stretch_sd"),
             stretch_doubt = numbers_in(table, "range_stretch_doubt"), blur = numbers_in(table, "blur_m");
  std::vector<StemEvidence> out(x.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = {{x[i], y[i]},
              std::nullopt,
              {offset[i], offset_sd[i], doubt[i]},
              {stretch[i], stretch_sd[i], stretch_doubt[i]},
              noise[i],
              blur[i],
              expected[i]};
  for (std::size_t k = 0; k < DriftLikelihoods{}.size(); ++k) {
    const auto values = numbers_in(table, drift_column(k));
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (std::isnan(values[i])) continue;
      if (!out[i].drift) out[i].drift.emplace();
      (*out[i].drift)[k] = values[i];
    }
  }
  return out;
}

Table priors_table(const PooledPriors& priors, std::size_t stems) {
  Table t;
  const auto add = [&](const char* name, double value) { t.set(name, std::vector<double>{value}); };
  t.set("stems", std::vector<std::int64_t>{static_cast<std::int64_t>(stems)});
  add("drift_pass_sd_m", priors.drift ? priors.drift->pass_sd_m : no_number);
  add("drift_view_sd_m", priors.drift ? priors.drift->view_sd_m : no_number);
  add("range_offset_m", priors.range_offset ? priors.range_offset->mean_m : no_number);
  add("range_offset_sd_m", priors.range_offset ? priors.range_offset->sd_m : no_number);
  add("range_stretch", priors.range_stretch ? priors.range_stretch->mean : no_number);
  add("range_stretch_sd", priors.range_stretch ? priors.range_stretch->sd : no_number);
  add("noise_m", priors.noise_m);
  add("blur_m", priors.blur.mean_m);
  add("blur_between_stems_m", priors.blur.between_m);
  return t;
}

PooledPriors priors_in(const Table& table) {
  PooledPriors out;
  const double pass = single(table, "drift_pass_sd_m"), view = single(table, "drift_view_sd_m"),
               offset = single(table, "range_offset_m"), offset_sd = single(table, "range_offset_sd_m"),
               stretch = single(table, "range_stretch"), stretch_sd = single(table, "range_stretch_sd"),
               noise = single(table, "noise_m"), blur = single(table, "blur_m"),
               between = single(table, "blur_between_stems_m");
  if (std::isfinite(pass) && std::isfinite(view)) out.drift = DriftPrior{pass, view};
  if (std::isfinite(offset) && std::isfinite(offset_sd)) out.range_offset = RangeOffsetPrior{offset, offset_sd};
  if (std::isfinite(stretch) && std::isfinite(stretch_sd)) out.range_stretch = RangeStretchPrior{stretch, stretch_sd};
  out.noise_m = std::isfinite(noise) ? noise : 0;
  if (std::isfinite(blur) && std::isfinite(between)) out.blur = {blur, between};
  return out;
}

}  // namespace bole::stems
