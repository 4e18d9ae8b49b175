#include "features/lesson/lesson_values.h"

#include <vtkCallbackCommand.h>
#include <vtkFunctionParser.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <regex>

#include "base/error.h"
#include "base/statistics.h"

namespace bole::desktop {
namespace {

std::pair<std::string, std::string> split_at_dot(const std::string& name) {
  const auto dot = name.find('.');
  return {name.substr(0, dot), name.substr(dot + 1)};
}

double measure_of(const std::string& name, const vtkbridge::RunOutcome& outcome) {
  const auto [stage, key] = split_at_dot(name);
  const auto it = std::ranges::find(outcome.stages, stage, [](const auto& s) { return s.record.id; });
  if (it == outcome.stages.end()) throw bad_input("the run has no stage '" + stage + "'", "one that gives " + name);
  const auto& report = it->record.report;
  if (const auto metric = report.metrics.find(key); metric != report.metrics.end()) return metric->second.value;
  if (const auto count = report.counts.find(key); count != report.counts.end())
    return static_cast<double>(count->second);
  throw bad_input("the stage '" + stage + "' reports no '" + key + "'", "one of its counts or measures");
}

bool same_cell(const Table& table, const std::string& column, std::size_t row, const std::string& wanted) {
  if (std::holds_alternative<std::vector<std::string>>(*table.find(column))) return table.texts(column)[row] == wanted;
  constexpr double same = 1e-9;
  return std::abs(table.numbers(column)[row] - std::strtod(wanted.c_str(), nullptr)) < same;
}

Table rows_where(const Table& table, const std::map<std::string, std::string>& where) {
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (std::ranges::all_of(where, [&](const auto& w) { return same_cell(table, w.first, row, w.second); }))
      kept.push_back(row);
  return table.subset(kept);
}

double statistic_of(std::vector<double> cells, const LessonNumber& number) {
  if (number.statistic == CellStatistic::count) return static_cast<double>(cells.size());
  if (cells.empty() || (number.statistic == CellStatistic::value && cells.size() != 1))
    throw bad_input(std::to_string(cells.size()) + " rows of " + number.table + " fit",
                    number.statistic == CellStatistic::value ? "one row" : "one row or more");
  const double sum = std::accumulate(cells.begin(), cells.end(), 0.0);
  switch (number.statistic) {
    case CellStatistic::sum:
      return sum;
    case CellStatistic::mean:
      return sum / static_cast<double>(cells.size());
    case CellStatistic::median:
      return median(std::move(cells));
    case CellStatistic::min:
      return std::ranges::min(cells);
    case CellStatistic::max:
      return std::ranges::max(cells);
    default:
      return cells.front();
  }
}

}  // namespace

double lesson_number(const LessonNumber& number, const LessonRun& run) {
  if (!number.measure.empty()) return measure_of(number.measure, run.outcome);
  const auto [stage, port] = split_at_dot(number.table);
  const auto found = run.results.find(stage);
  if (found == run.results.end()) throw bad_input("the run gave nothing of '" + stage + "'", number.table);
  const auto& table = found->second.table(port);
  for (const auto& [column, unused] : number.where)
    if (!table.has(column)) throw bad_input(number.table + " has no column '" + column + "'", "one of its columns");
  const auto rows = rows_where(table, number.where);
  if (number.statistic == CellStatistic::count && rows.has(number.column)) return static_cast<double>(rows.rows());
  return statistic_of(rows.numbers(number.column), number);
}

std::vector<std::string> names_in_expression(const std::string& expression) {
  static const std::regex name("[A-Za-z_][A-Za-z_0-9]*(?!\\s*\\(|[A-Za-z_0-9])");
  std::vector<std::string> names;
  for (std::sregex_iterator it(expression.begin(), expression.end(), name), end; it != end; ++it)
    names.push_back(it->str());
  return names;
}

double lesson_value(const std::string& expression, const std::map<std::string, double>& values) {
  vtkNew<vtkFunctionParser> parser;
  vtkNew<vtkCallbackCommand> silent;  // its errors are ours below
  parser->AddObserver(vtkCommand::ErrorEvent, silent);
  for (const auto& name : names_in_expression(expression)) {
    const auto it = values.find(name);
    if (it == values.end())
      throw bad_input("'" + name + "' in '" + expression + "' has no value", "a number of the run");
    parser->SetScalarVariableValue(name.c_str(), it->second);
  }
  parser->SetFunction(expression.c_str());
  const double value = parser->IsScalarResult() ? parser->GetScalarResult() : VTK_PARSER_ERROR_RESULT;
  if (value == VTK_PARSER_ERROR_RESULT || !std::isfinite(value))
    throw bad_input("'" + expression + "' gives no number", "an expression of numbers of the run");
  return value;
}

}  // namespace bole::desktop
