#include "stems/core/sensor_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cloud/core/laser_facts.h"

namespace bole::stems {
namespace {

enum class Source { option, cloud, assumed };

Source fill_in(std::optional<double>& option, const Facts& facts, const FactInfo& info, double otherwise) {
  if (option) return Source::option;
  option = fact_number(facts, info);
  if (option) return Source::cloud;
  option = otherwise;
  return Source::assumed;
}

std::string source_text(Source source, const Facts& facts) {
  switch (source) {
    case Source::option:
      return "option";
    case Source::cloud:
      return fact_text(facts, facts::sensor).value_or("from the cloud");
    case Source::assumed:
      return "assumed";
  }
  return "";
}

}  // namespace

double usual_range_offset_sd(double lasers) {
  return range_offset_of_many_lasers * std::sqrt(enough_lasers / std::clamp(lasers, 1.0, enough_lasers));
}

MeasureOptions with_sensor(MeasureOptions options, const Facts& facts, bool along_rays, Report& report) {
  const auto tell = [&](const char* name, double value, const char* unit, Source source) {
    report.facts[name] = fmt::format("{:.6g} {} ({})", value, unit, source_text(source, facts));
  };
  const auto divergence =
      fill_in(options.beam_divergence_mrad, facts, facts::beam_divergence, assumed_beam_divergence_mrad);
  // An option without a doubt beside it is taken at its word, and so is what the maker states.
  if (divergence == Source::option && !options.beam_divergence_sd_mrad) options.beam_divergence_sd_mrad = 0;
  const bool doubted = facts.contains(std::string(facts::beam_divergence_sd.key));
  const auto divergence_sd = fill_in(options.beam_divergence_sd_mrad, facts, facts::beam_divergence_sd,
                                     divergence == Source::assumed ? assumed_beam_divergence_sd_mrad : 0);
  const auto aperture = fill_in(options.beam_aperture, facts, facts::beam_aperture, assumed_beam_aperture);
  const auto noise = fill_in(options.range_noise, facts, facts::range_noise, assumed_range_noise);
  const auto lasers = fact_number(facts, facts::lasers);
  const auto offset = options.range_offset_sd ? Source::option : lasers ? Source::cloud : Source::assumed;
  if (!options.range_offset_sd) options.range_offset_sd = usual_range_offset_sd(lasers.value_or(enough_lasers));
  options.max_sigma = std::max(options.max_sigma, cap_by_noise * *options.range_noise);
  tell("range_noise", 1e3 * *options.range_noise, "mm", noise);
  if (!along_rays) return options;
  tell("beam_divergence", *options.beam_divergence_mrad, "mrad", divergence);
  if (*options.beam_divergence_sd_mrad > 0)
    tell("beam_divergence_sd", *options.beam_divergence_sd_mrad, "mrad", divergence_sd);
  tell("beam_aperture", 1e3 * *options.beam_aperture, "mm", aperture);
  if (options.estimate_range_offset) tell("range_offset_sd", 1e3 * *options.range_offset_sd, "mm", offset);
  if (divergence == Source::assumed || aperture == Source::assumed)
    report.warn(
        fmt::format("the cloud does not say how wide the beam of its sensor is: a divergence of {:.6g} mrad and {:.6g} "
                    "mm at the sensor are taken{}. Set beam_divergence and beam_aperture, or name the sensor when the "
                    "scan is read",
                    *options.beam_divergence_mrad, 1e3 * *options.beam_aperture,
                    divergence == aperture ? ", as of a VLP-32C" : ""));
  else if (divergence == Source::cloud && doubted)
    report.warn(
        fmt::format("the maker of {} does not state its beam: {:.6g} mrad of a similar sensor are taken, and "
                    "the intervals allow for +-{:.2g} mrad. Set beam_divergence where it is known",
                    fact_text(facts, facts::sensor).value_or("the sensor"), *options.beam_divergence_mrad,
                    1.96 * *options.beam_divergence_sd_mrad));
  return options;
}

}  // namespace bole::stems
