#include "stems/core/edits/table_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/option.h"

namespace bole::stems {
namespace {

using Cell = std::variant<double, std::int64_t, std::string>;

bool has_unit(std::string_view name) {
  constexpr std::array<std::string_view, 7> endings{"_m", "_cm", "_m2", "_m3", "_deg", "_pct", "_cm_per_m"};
  return std::ranges::any_of(endings, [&](std::string_view e) { return name.ends_with(e); });
}

double as_number(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const auto* value = std::get_if<double>(&cell);
  return value != nullptr ? *value : std::nan("");
}

std::string as_text(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double value = as_number(cell);
  return std::isnan(value) ? std::string() : number_text(value);
}

}  // namespace

TableRows::TableRows(const Table& table) : rows_(table.rows()), facts_(table.facts) {
  for (const auto& column : table.columns()) {
    names_.push_back(column.name);
    std::visit(
        [&](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_same_v<T, double>)
            empty_.emplace_back(std::numeric_limits<double>::quiet_NaN());
          else
            empty_.emplace_back(T());
          for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].emplace_back(values[i]);
        },
        column.values);
  }
  for (const auto& name : std::vector<std::string>(names_))
    if (const auto i = index(name); has_unit(name) && std::holds_alternative<std::int64_t>(empty_[i]))
      want_numbers(name);
}

std::size_t TableRows::index(std::string_view column) const {
  std::size_t i = 0;
  while (i < names_.size() && names_[i] != column) ++i;
  return i;
}

double TableRows::number(std::size_t row, std::string_view column) const {
  const auto i = index(column);
  if (i == names_.size()) return std::nan("");
  return as_number(rows_[row][i]);
}

std::int64_t TableRows::integer(std::size_t row, std::string_view column) const {
  const double value = number(row, column);
  return std::isfinite(value) ? std::llround(value) : 0;
}

void TableRows::set(std::size_t row, std::string_view column, double value) {
  const auto i = index(column);
  if (i == names_.size()) return;
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  if (std::holds_alternative<std::int64_t>(empty_[i]) && !whole) want_numbers(names_[i]);
  if (std::holds_alternative<std::int64_t>(empty_[i]))
    rows_[row][i] = static_cast<std::int64_t>(value);
  else if (std::holds_alternative<double>(empty_[i]))
    rows_[row][i] = value;
  else
    rows_[row][i] = as_text(value);
}

void TableRows::set(std::size_t row, std::string_view column, std::int64_t value) {
  set(row, column, static_cast<double>(value));
}

void TableRows::set(std::size_t row, std::string_view column, const std::string& value) {
  if (!has(column)) return;
  want_texts(std::string(column));
  rows_[row][index(column)] = value;
}

template <class T>
void TableRows::want(const std::string& column, const T& empty, T (*converted)(const Cell&)) {
  const auto i = index(column);
  if (i == names_.size()) {
    names_.push_back(column), empty_.emplace_back(empty);
    for (auto& row : rows_) row.emplace_back(empty);
  } else if (!std::holds_alternative<T>(empty_[i])) {
    empty_[i] = empty;
    for (auto& row : rows_) row[i] = converted(row[i]);
  }
}

void TableRows::want_texts(const std::string& column) { want<std::string>(column, {}, as_text); }

void TableRows::want_numbers(const std::string& column) { want<double>(column, std::nan(""), as_number); }

std::size_t TableRows::add() {
  rows_.push_back(empty_);
  return rows_.size() - 1;
}

Table TableRows::table() const {
  Table out;
  out.facts = facts_;
  for (std::size_t i = 0; i < names_.size(); ++i)
    std::visit(
        [&]<class T>(const T&) {
          std::vector<T> values;
          for (const auto& row : rows_) values.push_back(std::get<T>(row[i]));
          out.set(names_[i], std::move(values));
        },
        empty_[i]);
  return out;
}

}  // namespace bole::stems
