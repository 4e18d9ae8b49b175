#include "stems/core/sensor_facts.h"

#include <fmt/format.h>

#include <algorithm>

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

MeasureOptions with_sensor(MeasureOptions options, const Facts& facts, bool along_rays, Report& report) {
  const auto tell = [&](const char* name, double value, const char* unit, Source source) {
    report.facts[name] = fmt::format("{:.6g} {} ({})", value, unit, source_text(source, facts));
  };
  const auto divergence =
      fill_in(options.beam_divergence_mrad, facts, facts::beam_divergence, assumed_beam_divergence_mrad);
  const auto aperture = fill_in(options.beam_aperture, facts, facts::beam_aperture, assumed_beam_aperture);
  const auto noise = fill_in(options.range_noise, facts, facts::range_noise, assumed_range_noise);
  options.max_sigma = std::max(options.max_sigma, cap_by_noise * *options.range_noise);
  tell("range_noise", 1e3 * *options.range_noise, "mm", noise);
  if (!along_rays) return options;
  tell("beam_divergence", *options.beam_divergence_mrad, "mrad", divergence);
  tell("beam_aperture", 1e3 * *options.beam_aperture, "mm", aperture);
  if (divergence == Source::assumed || aperture == Source::assumed)
    report.warn(
        fmt::format("the cloud does not say how wide the beam of its sensor is: a divergence of {:.6g} mrad and {:.6g} "
                    "mm at the sensor are taken{}. Set beam_divergence and beam_aperture, or name the sensor when the "
                    "scan is read",
                    *options.beam_divergence_mrad, 1e3 * *options.beam_aperture,
                    divergence == aperture ? ", as of a VLP-32C" : ""));
  return options;
}

}  // namespace bole::stems
