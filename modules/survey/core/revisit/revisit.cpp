#include "survey/core/revisit/revisit.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/statistics.h"
#include "cloud/known_facts.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "survey/core/revisit/growth_table.h"

namespace bole::survey {
namespace {

SurveyedStand stand_of(const Table& table, const Table* rejected, double assumed_se_cm, std::size_t& assumed) {
  SurveyedStand s{table, {}, {}, {}, {}, std::numeric_limits<double>::infinity()};
  const auto x = table.numbers("x_m"), y = table.numbers("y_m"), dbh = table.numbers("dbh_cm");
  const auto lo = numbers_or_nan(table, "dbh_lo_cm"), hi = numbers_or_nan(table, "dbh_hi_cm");
  for (const auto i : kept_rows(table)) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    s.rows.push_back(i);
    s.trees.push_back({{x[i], y[i]}, dbh[i]});
    const double half = (hi[i] - lo[i]) / 2;
    assumed += !(half > 0);
    s.half_cm.push_back(half > 0 ? half : z_95 * assumed_se_cm);
    if (dbh[i] < s.min_dbh_cm) s.min_dbh_cm = dbh[i];
  }
  if (rejected != nullptr) {
    const auto rx = numbers_or_nan(*rejected, "x_m"), ry = numbers_or_nan(*rejected, "y_m");
    for (std::size_t i = 0; i < rx.size(); ++i) s.rejected.emplace_back(rx[i], ry[i]);
  }
  return s;
}

std::optional<std::chrono::sys_days> date_of(const Table& table) {
  for (const char* name : {"date", "recorded"})
    if (const auto it = table.facts.find(name); it != table.facts.end()) {
      int year = 0;
      unsigned month = 0, day = 0;
      if (std::sscanf(it->second.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) continue;
      const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
      if (date.ok()) return std::chrono::sys_days(date);
    }
  return std::nullopt;
}

std::optional<double> years_between(const Table& first, const Table& second, const RevisitOptions& o) {
  if (o.years) return o.years;
  const auto from = date_of(first), to = date_of(second);
  if (!from || !to) return std::nullopt;
  constexpr double days_per_year = 365.25;
  const double years = static_cast<double>((*to - *from).count()) / days_per_year;
  if (years <= 0)
    throw bad_input("the second survey is not later than the first (dates of the tables)",
                    "an earlier and a later survey", "Swap them, or set years");
  return years;
}

[[noreturn]] void refuse(const StandAlignment& a, std::size_t first, std::size_t second) {
  const auto found =
      fmt::format("two maps of {} and {} trees that {} of their trees bring together", first, second, a.pairs.size());
  if (a.rival_pairs > 0 && 2 * a.rival_pairs > a.pairs.size() && a.pairs.size() >= 5)
    throw bad_input(found + fmt::format(", and another turn or shift does the same for {}", a.rival_pairs),
                    "one motion that fits better than all others",
                    "Rows planted evenly look alike from both ends: bring both tables into the same axes "
                    "(survey.georeference, or the same targets) and set axes=same");
  throw bad_input(
      found, "at least 5 trees, a third of those that both cover, at the same places with like diameters",
      "Check that both are of the same plot, unmirrored, in metres; set axes=same where both lie in the same "
      "axes, and max_growth or match_distance where much has changed");
}

StandAlignment aligned(const SurveyedStand& a, const SurveyedStand& b, const RevisitOptions& o,
                       const AlignLimits& limits, const Run& run) {
  auto alignment = o.axes == RevisitAxes::same ? align_in_place(a.trees, b.trees, limits)
                                               : align_stands(a.trees, b.trees, limits, run);
  if (!alignment.certain) refuse(alignment, a.trees.size(), b.trees.size());
  return alignment;
}

void tell_findings(const UnmatchedTrees& kinds, const GrowthSums& sums, std::size_t assumed,
                   const std::optional<double>& years, Report& r) {
  constexpr double low_share = 0.7, many = 0.1;
  if (!years)
    r.find(Severity::note, "years_unknown",
           "the years between the surveys are not known: growth is that of the whole time. Set years");
  if (assumed > 0)
    r.find(Severity::look, "intervals_assumed",
           fmt::format("{} diameters have no interval: assumed_se was taken for them", assumed));
  if (const double share = kinds.matched_share(); share < low_share)
    r.find(Severity::look, "few_found_again",
           fmt::format("only {:.0f} % of the trees that both surveys cover were found again: felling, or one of the "
                       "surveys missed trees. Growth is that of the trees found again",
                       100 * share));
  if (sums.shrank > 1 && static_cast<double>(sums.shrank) > many * static_cast<double>(sums.matched))
    r.find(Severity::look, "trees_shrank",
           fmt::format("{} of {} trees are thinner in the second survey by more than their intervals: one survey has a "
                       "bias, the breast heights differ, or trees were confused",
                       sums.shrank, sums.matched));
  if (sums.missed > 0)
    r.find(Severity::note, "trees_missed", fmt::format("{} trees were missed by one of the surveys", sums.missed));
}

}  // namespace

Revisit revisit(const Table& first, const Table& second, const Table* first_rejected, const Table* second_rejected,
                const RevisitOptions& o, const Run& run) {
  std::size_t assumed = 0;
  const auto a = stand_of(first, first_rejected, o.assumed_se_cm, assumed);
  auto b = stand_of(second, second_rejected, o.assumed_se_cm, assumed);
  if (a.trees.empty() || b.trees.empty())
    throw bad_input(fmt::format("{} stems in the first and {} in the second table", a.trees.size(), b.trees.size()),
                    "stems in both");
  const auto years = years_between(first, second, o);
  constexpr double usual_years = 5;  // where nobody knows
  const double growth_cm = o.max_growth_cm * years.value_or(usual_years);
  const AlignLimits limits{o.match_distance, o.max_loss_cm, growth_cm + o.max_loss_cm};
  run.report(0.05, "Bringing the two maps together");
  const auto alignment = aligned(a, b, o, limits, run);
  for (auto& t : b.trees) t.at = alignment.T_first_second * t.at;
  for (auto& p : b.rejected) p = alignment.T_first_second * p;
  const UnmatchedTrees kinds(a, b, alignment.pairs, {growth_cm, o.min_dbh_cm});
  Revisit out;
  GrowthSums sums;
  out.growth = growth_table(a, b, alignment.pairs, kinds, o, years, sums);
  for (const auto* info : {&facts::axes, &facts::crs})
    if (const auto text = fact_text(first.facts, *info)) set_fact(out.growth.facts, *info, *text);
  out.values = value_table(sums, o, years);
  auto& r = out.report;
  const double turn = std::atan2(alignment.T_first_second.linear()(1, 0), alignment.T_first_second.linear()(0, 0));
  r.metrics["turn"] = {degrees(turn), Unit::degree};
  r.metrics["shift_x"] = {alignment.T_first_second.translation().x(), Unit::metre};
  r.metrics["shift_y"] = {alignment.T_first_second.translation().y(), Unit::metre};
  r.metrics["distance_rms"] = {100 * alignment.rms_m, Unit::centimetre};
  r.metrics["evidence"] = {alignment.evidence, Unit::none};
  r.metrics["rival_evidence"] = {alignment.rival_evidence, Unit::none};
  r.counts["rival_pairs"] = static_cast<std::int64_t>(alignment.rival_pairs);
  r.counts["matched"] = static_cast<std::int64_t>(sums.matched);
  for (const auto& [kind, n] : sums.of_kind) r.counts[kind] = n;
  r.counts["grew"] = static_cast<std::int64_t>(sums.grew);
  r.counts["shrank"] = static_cast<std::int64_t>(sums.shrank);
  if (years) r.metrics["years"] = {*years, Unit::none};
  r.message = fmt::format("{} trees found again (to {:.1f} cm), {} grew; mean growth {:.2f} cm{}", sums.matched,
                          100 * alignment.rms_m, sums.grew, sums.mean_growth_cm(),
                          years ? fmt::format(" in {:.1f} years", *years) : "");
  tell_findings(kinds, sums, assumed, years, r);
  return out;
}

}  // namespace bole::survey
