#include "evaluation/core/listed_trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/no_number.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"

namespace bole::evaluation {
namespace {

std::optional<std::int64_t> whole_number(const Table& t, const std::string& column, std::size_t row) {
  if (const auto* values = std::get_if<std::vector<double>>(t.find(column))) {
    const double v = (*values)[row];
    return std::abs(v) < 1e15 && v == std::floor(v) ? std::optional(static_cast<std::int64_t>(v)) : std::nullopt;
  }
  std::int64_t number = 0;
  const auto text = t.text(column, row);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Whole numbers are ids as they are. Names ("A12") are kept, and they and blanks get the next free number.
void take_ids(const Table& t, std::vector<ListedTree>& trees) {
  if (!t.has("tree_id")) {
    for (std::size_t i = 0; i < trees.size(); ++i) trees[i].id = static_cast<std::int64_t>(i) + 1;
    return;
  }
  std::int64_t last = 0;
  std::vector<std::size_t> nameless;
  for (std::size_t i = 0; i < trees.size(); ++i)
    if (const auto id = whole_number(t, "tree_id", i)) {
      trees[i].id = *id;
      last = std::max(last, *id);
    } else {
      trees[i].name = t.text("tree_id", i);
      nameless.push_back(i);
    }
  for (const auto i : nameless) trees[i].id = ++last;
}

}  // namespace

std::vector<ListedTree> trees_of(const Table& t, const std::string& what, std::vector<std::string>& warnings) {
  const auto x = t.numbers("x_m"), y = t.numbers("y_m"), dbh = t.numbers("dbh_cm");
  const auto optional = [&](const char* name) {
    return t.has(name) ? t.numbers(name) : std::vector<double>(t.rows(), no_number);
  };
  const auto low = optional("dbh_lo_cm"), high = optional("dbh_hi_cm"), height = optional("height_m"),
             seen = optional("height_seen");
  const auto species = texts_or_empty(t, "species");
  std::vector<ListedTree> out;
  for (std::size_t i = 0; i < t.rows(); ++i)
    out.push_back({0, {}, {x[i], y[i]}, dbh[i], low[i], high[i], height[i], !(seen[i] == 0), species[i]});
  take_ids(t, out);
  const auto placeless = std::erase_if(out, [](const ListedTree& tree) { return !tree.at.allFinite(); });
  if (placeless > 0 && out.empty()) throw bad_input("no row of the " + what + " has a position", "x_m and y_m");
  if (placeless > 0)
    warnings.push_back(
        fmt::format("{} of {} rows of the {} have no position and are left out", placeless, t.rows(), what));
  return out;
}

Table without_rejected(const Table& stems) { return stems.subset(kept_rows(stems)); }

}  // namespace bole::evaluation
