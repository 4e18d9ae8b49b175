#include "rows/core/rows/joined_tables.h"

#include <limits>

namespace bole::rows {
namespace {

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

template <class T>
T blank() {
  if constexpr (std::is_same_v<T, double>)
    return std::numeric_limits<double>::quiet_NaN();
  else
    return T();
}

// The column as T; blanks where the table has none.
template <class T>
std::vector<T> column_as(const Table& t, const std::string& name) {
  const auto* values = t.find(name);
  if (values == nullptr) return std::vector<T>(t.rows(), blank<T>());
  if (const auto* same = std::get_if<std::vector<T>>(values)) return *same;
  std::vector<T> out;
  if constexpr (std::is_same_v<T, double>) out = t.numbers(name);
  if constexpr (std::is_same_v<T, std::string>)
    for (std::size_t i = 0; i < t.rows(); ++i) out.push_back(t.text(name, i));
  return out;
}

template <class T>
bool holds(const Table& t, const std::string& name) {
  return t.find(name) != nullptr && std::holds_alternative<std::vector<T>>(*t.find(name));
}

template <class T>
void append(const Table& a, const Table& b, const std::string& name, Table& out) {
  auto values = column_as<T>(a, name);
  const auto more = column_as<T>(b, name);
  values.insert(values.end(), more.begin(), more.end());
  out.set(name, std::move(values));
}

}  // namespace

Table joined(const Table& a, const Table& b) {
  Table out;
  out.facts = a.facts;
  out.facts.insert(b.facts.begin(), b.facts.end());
  for (const Table* from : {&a, &b})
    for (const auto& column : from->columns()) {
      if (out.has(column.name)) continue;
      if (holds<std::string>(a, column.name) || holds<std::string>(b, column.name))
        append<std::string>(a, b, column.name, out);
      else if (holds<double>(a, column.name) || holds<double>(b, column.name))
        append<double>(a, b, column.name, out);
      else
        append<std::int64_t>(a, b, column.name, out);
    }
  return out;
}

Table with_blank_rows(const Table& table, std::size_t count) {
  Table out;
  out.facts = table.facts;
  for (const auto& column : table.columns())
    std::visit(
        [&]<class T>(std::vector<T> values) {
          values.insert(values.end(), count, blank<T>());
          out.set(column.name, std::move(values));
        },
        column.values);
  return out;
}

}  // namespace bole::rows
