// Which trees a person should look at before signing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/survey_data.h"

namespace bole::report {

struct LookList {
  std::vector<std::size_t> rows;  // of data.stems, in the plot, the least certain first
  std::size_t outside = 0;        // more of them outside the plot
  std::size_t in_plot = 0;        // all stems in the plot that no person rejected
};

// Stems that ask for a look or have a poor diameter, unless a person decided about them already.
LookList trees_to_look_at(const SurveyData& data);

// What stands for a tree on the page: its id, or its number in the table.
std::string tree_name(const Table& stems, std::size_t row);

// The tables are written in ASCII; the page is not: "+-5 deg" as "±5°".
std::string typeset(std::string text);

}  // namespace bole::report
