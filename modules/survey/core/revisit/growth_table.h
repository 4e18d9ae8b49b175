// The tables of a comparison of two surveys.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "survey/core/revisit/revisit_kinds.h"
#include "survey/core/revisit/revisit_options.h"

namespace bole::survey {

struct GrowthSums {
  std::size_t matched = 0, grew = 0, shrank = 0, missed = 0, crossed = 0;  // crossed: min_dbh between the surveys
  std::size_t counted_first = 0;  // matched or gone trees of min_dbh and more in the first survey
  std::size_t gone = 0;           // of these
  std::map<std::string, std::int64_t> of_kind;
  double growth_cm = 0, variance_cm2 = 0;          // sums over the matched; the variances without the shared part
  double basal_first_m2 = 0, basal_second_m2 = 0;  // of the matched
  double basal_variance_m4 = 0;                    // of their difference, without the shared part
  double basal_slope_m2_per_cm = 0;                // of their difference by an error that all diameters share
  double mean_growth_cm() const { return matched > 0 ? growth_cm / static_cast<double>(matched) : 0; }
};

Table growth_table(const SurveyedStand& first, const SurveyedStand& second, const std::vector<TreePair>& pairs,
                   const UnmatchedTrees& kinds, const RevisitOptions& options, const std::optional<double>& years,
                   GrowthSums& sums);

Table value_table(const GrowthSums& sums, const RevisitOptions& options, const std::optional<double>& years);

}  // namespace bole::survey
