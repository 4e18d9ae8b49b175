#include "stems/core/survey_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "stems/core/bark_findings.h"

namespace bole::stems {
namespace {

std::string no_stems(const SurveyFacts& facts, const MeasureOptions& options) {
  if (facts.layer_points == 0)
    return fmt::format(
        "no stem found: no point lies {:.1f} to {:.1f} m above ground; set search_bottom and search_top to heights "
        "that the cloud has",
        options.search_bottom, options.search_top);
  if (facts.circles == 0)
    return fmt::format(
        "no stem found: {} points between {:.1f} and {:.1f} m, but no circle of {:.0f} deg among them; lower min_arc "
        "or min_dbh, or change the search heights",
        facts.layer_points, options.search_bottom, options.search_top, options.min_arc_deg);
  if (facts.candidates == 0) {
    return fmt::format(
        "no stem found: {} circles, none of them at min_sections = {} heights above one another; lower it, or widen "
        "search_bottom to search_top",
        facts.circles, options.min_sections);
  }
  return fmt::format("no stem found: all {} candidates were rejected; the table 'rejected' says why", facts.candidates);
}

}  // namespace

void number(StemSurvey& survey) {
  std::ranges::sort(survey.stems, [](const Stem& a, const Stem& b) {
    return std::pair(-a.breast_height.y(), a.breast_height.x()) < std::pair(-b.breast_height.y(), b.breast_height.x());
  });
  for (std::size_t i = 0; i < survey.stems.size(); ++i) survey.stems[i].id = static_cast<int>(i) + 1;
  std::ranges::sort(survey.rejected, [](const RejectedStem& a, const RejectedStem& b) {
    return std::pair(-a.position.y(), a.position.x()) < std::pair(-b.position.y(), b.position.x());
  });
}

void report_survey(StemSurvey& survey, const SurveyFacts& facts, const MeasureOptions& options) {
  auto& r = survey.report;
  r.counts["stems"] = static_cast<std::int64_t>(survey.stems.size());
  r.counts["rejected"] = static_cast<std::int64_t>(survey.rejected.size());
  r.counts["candidates"] = static_cast<std::int64_t>(facts.candidates);
  r.counts["circles"] = static_cast<std::int64_t>(facts.circles);
  r.facts["axes"] = axes_name(survey.points.axes);
  r.facts["fit"] = facts.along_rays ? "along rays" : "surface distance";
  const auto to_check = std::ranges::count(survey.stems, "check", &Stem::state);
  r.message = fmt::format("{} stems, {} to check, {} candidates rejected", survey.stems.size(), to_check,
                          survey.rejected.size());
  if (options.model == FitModel::ray && !facts.rays_known)
    r.warn(
        "model is 'ray' but no sensor position is known: the surface distance was used. Give sensor_x, sensor_y, "
        "sensor_z, or time with a trajectory");
  if (survey.stems.empty()) r.find(Severity::look, "no_stems", no_stems(facts, options));
  if (facts.moved_m > 0) {
    r.metrics["passes_moved"] = {100 * facts.moved_m, Unit::centimetre};
    r.warn(fmt::format("passes of the walk disagree by {:.1f} cm: they were brought together by the stems",
                       100 * facts.moved_m));
  }
  judge_bark(survey.stems, options, facts.along_rays, facts.noise_m, r);
}

}  // namespace bole::stems
