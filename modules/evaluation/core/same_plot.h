// Whether two lists of trees are of one plot and in one system of axes and units.
#pragma once

#include <cstddef>
#include <string>

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {

// Of the trees of the shorter list: where fewer agree, figures of a comparison are those of pairs that met by chance.
constexpr double usual_agreement_pct = 50;

// The matched trees by those of the list that has fewer of them.
struct Agreement {
  std::size_t matched = 0, smaller = 0;
  double share() const { return smaller == 0 ? 0 : static_cast<double>(matched) / static_cast<double>(smaller); }
};
Agreement agreement_of(const StemEvaluation& evaluation);

// Why two lists do not agree, in words that end in what to do: other units of diameters or of positions, swapped or
// turned axes, or another plot. Tries each and takes what brings 70 % of the smaller list (at least 6 trees) together.
std::string why_they_differ(const Table& estimate, const Table& reference, const EvaluationOptions& options,
                            const CountingRule& rule);

}  // namespace bole::evaluation
