#include "report/core/look_list.h"

#include <string_view>

#include "cloud/table_columns.h"
#include "render/charts/worst_first.h"

namespace bole::report {
namespace {

// Whether a person has looked at the stem and said what it is.
bool decided(const std::string& state) { return state == "accepted" || state == "edited" || state == "rejected"; }

}  // namespace

LookList trees_to_look_at(const SurveyData& d) {
  LookList list;
  if (d.stems == nullptr) return list;
  const auto state = texts_or_empty(*d.stems, "state"), quality = texts_or_empty(*d.stems, "quality");
  const auto x = numbers_or_nan(*d.stems, "x_m"), y = numbers_or_nan(*d.stems, "y_m");
  for (const auto i : render::worst_first(*d.stems)) {
    const bool inside = d.rule.area.contains(x[i], y[i]);
    if (inside && state[i] != "rejected") ++list.in_plot;
    if (decided(state[i]) || (state[i] != "check" && quality[i] != "poor")) continue;
    if (inside)
      list.rows.push_back(i);
    else
      ++list.outside;
  }
  return list;
}

std::string tree_name(const Table& stems, std::size_t row) {
  return stems.has("tree_id") ? stems.text("tree_id", row, 0) : std::to_string(row + 1);
}

std::string typeset(std::string text) {
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("+-", "±");
  replace(" deg", "°");
  return text;
}

}  // namespace bole::report
