#include "cloud/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/option.h"

namespace bole {
inline namespace cloud {

const Table::Values* Table::find(std::string_view name) const {
  const auto it = std::ranges::find(columns_, name, &NamedColumn::name);
  return it == columns_.end() ? nullptr : &it->values;
}

void Table::set(std::string_view name, Values values) {
  const std::size_t length = std::visit([](const auto& v) { return v.size(); }, values);
  if (columns_.empty()) rows_ = length;
  if (length != rows_)
    throw failure("table column '" + std::string(name) + "' has " + std::to_string(length) + " rows",
                  std::to_string(rows_));
  const auto it = std::ranges::find(columns_, name, &NamedColumn::name);
  if (it != columns_.end())
    it->values = std::move(values);
  else
    columns_.push_back({std::string(name), std::move(values)});
}

void Table::remove(std::string_view name) {
  std::erase_if(columns_, [&](const NamedColumn& c) { return c.name == name; });
  if (columns_.empty()) rows_ = 0;
}

namespace {

const Table::Values& require(const Table& table, std::string_view name) {
  if (const auto* v = table.find(name)) return *v;
  std::string list;
  for (const auto& c : table.columns()) list += (list.empty() ? "" : ", ") + c.name;
  throw bad_input("the table has no column '" + std::string(name) + "'", "one of that name",
                  "It has: " + (list.empty() ? "none" : list));
}

}  // namespace

std::vector<double> Table::numbers(std::string_view name) const {
  const auto& v = require(*this, name);
  if (const auto* d = std::get_if<std::vector<double>>(&v)) return *d;
  if (const auto* i = std::get_if<std::vector<std::int64_t>>(&v)) return {i->begin(), i->end()};
  throw bad_input("column '" + std::string(name) + "' holds text", "numbers");
}

std::vector<std::int64_t> Table::integers(std::string_view name) const {
  if (const auto* i = std::get_if<std::vector<std::int64_t>>(&require(*this, name))) return *i;
  throw bad_input("column '" + std::string(name) + "' does not hold whole numbers", "whole numbers");
}

const std::vector<std::string>& Table::texts(std::string_view name) const {
  if (const auto* s = std::get_if<std::vector<std::string>>(&require(*this, name))) return *s;
  throw bad_input("column '" + std::string(name) + "' holds numbers", "text");
}

std::string Table::text(std::string_view name, std::size_t row, int decimals) const {
  const auto& v = require(*this, name);
  if (const auto* s = std::get_if<std::vector<std::string>>(&v)) return (*s)[row];
  if (const auto* i = std::get_if<std::vector<std::int64_t>>(&v)) return std::to_string((*i)[row]);
  const double value = std::get<std::vector<double>>(v)[row];
  if (std::isnan(value)) return "";
  if (decimals < 0) return number_text(value);
  std::array<char, 512> buffer;  // room for the largest double; printf would write the point of the system's language
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed,
                                 std::min(decimals, 100));
  return {buffer.data(), end.ptr};
}

Table Table::subset(const std::vector<std::size_t>& indices) const {
  Table out;
  out.facts = facts;
  for (const auto& c : columns_)
    out.set(c.name, std::visit(
                        [&](const auto& values) -> Values {
                          std::decay_t<decltype(values)> picked;
                          for (const auto i : indices) picked.push_back(values[i]);
                          return picked;
                        },
                        c.values));
  return out;
}

}  // namespace cloud
}  // namespace bole
