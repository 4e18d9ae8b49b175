#include "stems/core/table_rows.h"

#include <cmath>
#include <limits>

namespace bole {

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
}

std::size_t TableRows::index(std::string_view column) const {
  std::size_t i = 0;
  while (i < names_.size() && names_[i] != column) ++i;
  return i;
}

double TableRows::number(std::size_t row, std::string_view column) const {
  const auto i = index(column);
  if (i == names_.size()) return std::nan("");
  const auto& cell = rows_[row][i];
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const auto* value = std::get_if<double>(&cell);
  return value != nullptr ? *value : std::nan("");
}

std::int64_t TableRows::integer(std::size_t row, std::string_view column) const {
  const double value = number(row, column);
  return std::isfinite(value) ? std::llround(value) : 0;
}

void TableRows::set(std::size_t row, std::string_view column, double value) {
  const auto i = index(column);
  if (i == names_.size()) return;
  if (std::holds_alternative<std::int64_t>(empty_[i]))
    rows_[row][i] = static_cast<std::int64_t>(std::llround(value));
  else if (std::holds_alternative<double>(empty_[i]))
    rows_[row][i] = value;
}

void TableRows::set(std::size_t row, std::string_view column, std::int64_t value) {
  set(row, column, static_cast<double>(value));
}

void TableRows::set(std::size_t row, std::string_view column, const std::string& value) {
  const auto i = index(column);
  if (i < names_.size() && std::holds_alternative<std::string>(empty_[i])) rows_[row][i] = value;
}

void TableRows::want_texts(const std::string& column) {
  if (has(column)) return;
  names_.push_back(column);
  empty_.emplace_back(std::string());
  for (auto& row : rows_) row.emplace_back(std::string());
}

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

}  // namespace bole
