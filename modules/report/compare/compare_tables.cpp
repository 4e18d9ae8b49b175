#include "report/compare/compare_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cloud/table_columns.h"
#include "render/draw/axes.h"

namespace bole::report {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 6> words{{{"scope", "rows"},
                                                                    {"plot", "plot"},
                                                                    {"system", "system"},
                                                                    {"name", "run"},
                                                                    {"against", "against"},
                                                                    {"runs", "runs"}}};

std::string published_name(const ComparePart::Column& column) { return std::string("published_") + column.name; }

std::vector<std::size_t> filled_rows(const ComparePart& part, const Table& measures) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < measures.rows(); ++i)
    if (std::ranges::any_of(
            part.columns, [&](const auto& column) { return std::isfinite(numbers_or_nan(measures, column.name)[i]); }))
      rows.push_back(i);
  return rows;
}

bool any_number(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
}

std::string scope_words(const std::string& scope) {
  if (scope == "run") return "run";
  if (scope == "plot") return "plot, pooled";
  if (scope == "overall") return "all plots, pooled";
  return scope;
}

}  // namespace

const std::vector<ComparePart>& compare_parts() {
  static const std::vector<ComparePart> parts{
      {"positions.csv",
       "Stem positions",
       "Errors in metres (of pairs: differences): mean, standard deviations, covariance in m² (table 2 of the paper "
       "calls it rho), correlation, standard deviation in the worst direction, RMSE. All divided by n.",
       {{"mu_x_m", "μ x", 3},
        {"mu_y_m", "μ y", 3},
        {"sigma_x_m", "σ x", 3},
        {"sigma_y_m", "σ y", 3},
        {"cov_xy_m2", "covariance xy", 5},
        {"correlation_xy", "correlation", 2},
        {"sigma_max_m", "σ max", 3},
        {"rmse_x_m", "RMSE x", 3},
        {"rmse_y_m", "RMSE y", 3}}},
      {"diameters.csv",
       "Diameters",
       "relBIAS and relRMSE are the mean and the root mean square of (estimate − reference) / reference.",
       {{"dbh_trees", "trees", 0},
        {"dbh_bias_cm", "BIAS (cm)", 2},
        {"dbh_rel_bias_pct", "relBIAS (%)", 2},
        {"dbh_rmse_cm", "RMSE (cm)", 2},
        {"dbh_rel_rmse_pct", "relRMSE (%)", 2},
        {"dbh_interval_coverage_pct", "intervals that hold (%)", 1}}},
      {"detection.csv",
       "Trees found",
       "Reference trees that count, and how many of them each run has; extra trees match none.",
       {{"reference_trees", "reference", 0},
        {"matched", "found", 0},
        {"missed", "missed", 0},
        {"extra", "extra", 0},
        {"completeness_pct", "found (%)", 1},
        {"correctness_pct", "right (%)", 1}}},
      {"trajectories.csv",
       "Trajectories",
       "ATE after the best rigid motion, RPE over a step of time and over a distance, drift of the end by distance "
       "travelled.",
       {{"poses", "poses", 0},
        {"length_m", "length (m)", 1},
        {"ate_rmse_m", "ATE RMSE (m)", 4},
        {"ate_max_m", "ATE max (m)", 4},
        {"rpe_translation_m", "RPE (m)", 4},
        {"rpe_rotation_deg", "RPE (deg)", 3},
        {"rpe_distance_m", "RPE by distance (m)", 4},
        {"drift_pct", "drift (%)", 3}}}};
  return parts;
}

Table part_table(const ComparePart& part, const Table& measures) {
  const Table rows = measures.subset(filled_rows(part, measures));
  Table out;
  for (const auto& [name, heading] : words) out.set(name, *rows.find(name));
  for (const auto& column : part.columns) out.set(column.name, rows.numbers(column.name));
  for (const auto& column : part.columns)
    if (const auto values = numbers_or_nan(rows, published_name(column)); any_number(values))
      out.set(published_name(column), values);
  return out;
}

Table printed_part(const ComparePart& part, const Table& measures) {
  const Table rows = part_table(part, measures);
  Table out;
  for (const auto& [name, heading] : words) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < rows.rows(); ++i)
      texts.push_back(std::string(name) == "scope" ? scope_words(rows.text(name, i)) : rows.text(name, i));
    out.set(name, std::move(texts));
  }
  for (const auto& column : part.columns) {
    const auto values = rows.numbers(column.name), published = numbers_or_nan(rows, published_name(column));
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values.size(); ++i) {
      auto text = render::fixed(values[i], column.decimals);
      if (std::isfinite(published[i])) text += " (" + render::fixed(published[i], column.decimals) + ")";
      texts.push_back(std::move(text));
    }
    out.set(column.name, std::move(texts));
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> page_columns(const ComparePart& part, const Table& printed) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (const auto& [name, heading] : words) {
    const auto& texts = printed.texts(name);
    if (std::ranges::any_of(texts, [](const auto& t) { return !t.empty() && t != "1"; }))
      columns.emplace_back(name, heading);
  }
  for (const auto& column : part.columns) columns.emplace_back(column.name, column.heading);
  return columns;
}

}  // namespace bole::report
