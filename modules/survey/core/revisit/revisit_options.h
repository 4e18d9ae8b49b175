// Options of the comparison of two surveys of one plot.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/option.h"

namespace bole::survey {

// search: nothing is known of the two axes. same: both tables lie in the same axes already (georeferenced, or the same
// targets), up to match_distance.
enum class RevisitAxes { search, same };
constexpr std::array<std::string_view, 2> choice_names(RevisitAxes) { return {"search", "same"}; }

struct RevisitOptions {
  RevisitAxes axes = RevisitAxes::search;
  std::optional<double> years{};
  double match_distance = 0.5;
  double max_growth_cm = 2.5;
  double max_loss_cm = 4.0;
  double min_dbh_cm = 7.5;
  double shared_bias_cm = 0.1;
  double assumed_se_cm = 0.5;
};

const OptionTable& option_table(const RevisitOptions*);

}  // namespace bole::survey
