#include "evaluation/core/same_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/no_number.h"
#include "base/statistics.h"

namespace bole::evaluation {
namespace {

constexpr double convincing_share = 0.7;
constexpr std::size_t convincing_trees = 6;

bool convinces(const Agreement& a) { return a.matched >= convincing_trees && a.share() >= convincing_share; }

struct UnitFactor {
  double factor;  // of the numbers as they are
  const char* words;
};
// What a list is taken for that is in another unit than its headings say.
constexpr std::array<UnitFactor, 5> length_factors{{{0.3048, "feet"},
                                                    {0.01, "centimetres"},
                                                    {0.001, "millimetres"},
                                                    {1 / 0.3048, "metres, the other list in feet"},
                                                    {100, "metres, the other list in centimetres"}}};
constexpr std::array<UnitFactor, 5> diameter_factors{{{0.1, "millimetres"},
                                                      {100, "metres"},
                                                      {2.54, "inches"},
                                                      {10, "centimetres, those of the other list in millimetres"},
                                                      {1 / 2.54, "centimetres, those of the other list in inches"}}};

Table with_places(const Table& stems, std::vector<double> x, std::vector<double> y) {
  Table out = stems;
  out.set("x_m", std::move(x));
  out.set("y_m", std::move(y));
  return out;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

// Of positions that agree: what the diameters would have to be multiplied by.
std::string diameter_unit(const StemEvaluation& evaluation) {
  const auto estimate = evaluation.matches.numbers("dbh_cm"), reference = evaluation.matches.numbers("ref_dbh_cm");
  std::vector<double> ratios;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    if (estimate[i] > 0 && reference[i] > 0) ratios.push_back(reference[i] / estimate[i]);
  if (ratios.empty()) return {};
  const double ratio = median(ratios);
  constexpr double tolerance = 0.15;
  for (const auto& f : diameter_factors)
    if (std::abs(ratio / f.factor - 1) < tolerance) return f.words;
  return {};
}

}  // namespace

Agreement agreement_of(const StemEvaluation& e) {
  return {e.matched, std::min(e.matched + e.missed, e.matched + e.extra)};
}

std::string why_they_differ(const Table& estimate, const Table& reference, const EvaluationOptions& given,
                            const CountingRule& rule) {
  // Where nothing is known of units and axes, a boundary in them means nothing.
  const CountingRule all{{}, rule.min_dbh_cm};
  EvaluationOptions options = given;
  options.align_stems = AlignStems::none;
  options.dbh_gate_cm = 0;
  const auto by_place = evaluate_stems(estimate, reference, options, {});
  if (convinces(agreement_of(by_place))) {
    const auto unit = diameter_unit(by_place);
    return unit.empty() ? "their places agree, their diameters do not (dbh_gate): are both at breast height, in cm?"
                        : "their places agree, and the diameters look like " + unit +
                              ". Name the unit: dbh_cm=COLUMN:UNIT in the columns of the list";
  }
  options = given;
  options.align_stems = AlignStems::none;
  const auto x = estimate.numbers("x_m"), y = estimate.numbers("y_m");
  for (const auto& f : length_factors)
    if (convinces(agreement_of(
            evaluate_stems(with_places(estimate, scaled(x, f.factor), scaled(y, f.factor)), reference, options, all))))
      return fmt::format("their places agree when multiplied by {:.4g}: they look like {}", f.factor, f.words);
  if (convinces(agreement_of(evaluate_stems(with_places(estimate, y, x), reference, options, all))))
    return "their places agree with x and y swapped";
  options.align_stems = AlignStems::search;
  const auto turned = evaluate_stems(estimate, reference, options, all);
  if (convinces(agreement_of(turned))) {
    const auto& names = turned.summary.texts("measure");
    const auto values = turned.summary.numbers("value");
    const auto value = [&](const char* name) {
      const auto it = std::ranges::find(names, name);
      return it == names.end() ? no_number : values[static_cast<std::size_t>(it - names.begin())];
    };
    return fmt::format(
        "they are in other axes: turned by {:.1f} deg and moved by ({:.2f}, {:.2f}) m, {} trees agree. "
        "align_stems=search compares them so",
        value("align_turn"), value("align_shift_x"), value("align_shift_y"), turned.matched);
  }
  return "neither another unit nor another place of the axes brings them together: they are of different plots";
}

}  // namespace bole::evaluation
