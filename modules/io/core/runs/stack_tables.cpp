#include "io/core/runs/stack_tables.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/no_number.h"

namespace bole::io {
namespace {

enum class CellKind { integer, number, text };

CellKind kind_in(const Table& table, const std::string& name) {
  const auto* values = table.find(name);
  if (values == nullptr) return CellKind::number;  // for the missing values
  return std::holds_alternative<std::vector<std::string>>(*values)    ? CellKind::text
         : std::holds_alternative<std::vector<std::int64_t>>(*values) ? CellKind::integer
                                                                      : CellKind::number;
}

std::vector<std::string> texts_in(const Table& table, const std::string& name) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < table.rows(); ++i) out.push_back(table.has(name) ? table.text(name, i) : std::string());
  return out;
}

template <class T, class Take>
std::vector<T> joined(const std::vector<const Table*>& tables, Take take) {
  std::vector<T> all;
  for (const auto* table : tables) {
    if (table == nullptr) continue;
    const std::vector<T> part = take(*table);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

Table::Values column_of(const std::vector<const Table*>& tables, const std::string& name) {
  CellKind kind = CellKind::integer;
  for (const auto* table : tables)
    if (table != nullptr && table->rows() > 0) kind = std::max(kind, kind_in(*table, name));
  if (kind == CellKind::text) return joined<std::string>(tables, [&](const Table& t) { return texts_in(t, name); });
  if (kind == CellKind::number)
    return joined<double>(tables, [&](const Table& t) {
      return t.has(name) && t.rows() > 0 ? t.numbers(name) : std::vector<double>(t.rows(), no_number);
    });
  return joined<std::int64_t>(
      tables, [&](const Table& t) { return t.rows() > 0 ? t.integers(name) : std::vector<std::int64_t>(); });
}

}  // namespace

Table stack_tables(const std::vector<const Table*>& tables) {
  Table out;
  std::vector<std::int64_t> run;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (tables[i] == nullptr) continue;
    run.insert(run.end(), tables[i]->rows(), static_cast<std::int64_t>(i) + 1);
    for (const auto& column : tables[i]->columns())
      if (column.name != "run" && std::ranges::find(names, column.name) == names.end()) names.push_back(column.name);
  }
  out.set("run", std::move(run));
  for (const auto& name : names) out.set(name, column_of(tables, name));
  return out;
}

}  // namespace bole::io
