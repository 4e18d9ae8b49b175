#include "evaluation/core/comparison_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/no_number.h"
#include "base/option_text.h"
#include "cloud/table_columns.h"
#include "evaluation/core/published.h"

namespace bole::evaluation {
namespace {

using Numbers = std::vector<std::pair<const char*, double>>;

Numbers tree_numbers(const ComparisonRow& r) {
  const auto& t = r.trees;
  const auto p = position_measures(t.positions);
  const auto d = diameter_measures(t.diameters);
  const auto known = [&](double value) { return r.has_trees ? value : no_number; };
  return {{"reference_trees", known(t.matched + t.missed)},
          {"matched", known(t.matched)},
          {"missed", known(t.missed)},
          {"extra", known(t.extra)},
          {"completeness_pct", known(share_percent(t.matched, t.matched + t.missed))},
          {"correctness_pct", known(share_percent(t.matched, t.matched + t.extra))},
          {"mu_x_m", p.mean.x()},
          {"mu_y_m", p.mean.y()},
          {"sigma_x_m", p.sigma.x()},
          {"sigma_y_m", p.sigma.y()},
          {"cov_xy_m2", p.covariance(0, 1)},
          {"correlation_xy", p.correlation},
          {"sigma_max_m", p.max_sigma},
          {"rmse_x_m", p.rmse.x()},
          {"rmse_y_m", p.rmse.y()},
          {"dbh_trees", known(static_cast<double>(d.n))},
          {"dbh_bias_cm", d.bias_cm},
          {"dbh_rel_bias_pct", d.relative_bias_pct},
          {"dbh_rmse_cm", d.rmse_cm},
          {"dbh_rel_rmse_pct", d.relative_rmse_pct},
          {"dbh_interval_coverage_pct", d.coverage_pct}};
}

Numbers path_numbers(const PathErrors& p) {
  return {{"poses", p.poses},
          {"length_m", p.length_m},
          {"ate_rmse_m", p.ate_rmse_m},
          {"ate_max_m", p.ate_max_m},
          {"rpe_translation_m", p.rpe_translation_m},
          {"rpe_rotation_deg", p.rpe_rotation_deg},
          {"rpe_distance_m", p.rpe_distance_m},
          {"drift_pct", p.drift_pct}};
}

// Our columns and the measures that the published figures go by.
constexpr std::array<std::pair<const char*, const char*>, 12> published_columns{
    {{"published_mu_x_m", "position_mean_x"},
     {"published_mu_y_m", "position_mean_y"},
     {"published_sigma_x_m", "position_sigma_x"},
     {"published_sigma_y_m", "position_sigma_y"},
     {"published_cov_xy_m2", "position_cov_xy"},
     {"published_sigma_max_m", "position_sigma_max"},
     {"published_rmse_x_m", "position_rmse_x"},
     {"published_rmse_y_m", "position_rmse_y"},
     {"published_dbh_bias_cm", "dbh_bias"},
     {"published_dbh_rel_bias_pct", "dbh_relative_bias"},
     {"published_dbh_rmse_cm", "dbh_rmse"},
     {"published_dbh_rel_rmse_pct", "dbh_relative_rmse"}}};

void set_numbers(Table& table, const std::vector<Numbers>& rows) {
  if (rows.empty()) return;
  for (std::size_t c = 0; c < rows.front().size(); ++c) {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row[c].second);
    table.set(rows.front()[c].first, std::move(values));
  }
}

}  // namespace

void TreeErrors::add(const Table& matches) {
  const auto& kind = matches.texts("kind");
  const auto dx = matches.numbers("dx_m"), dy = matches.numbers("dy_m"), dbh = matches.numbers("dbh_cm"),
             ref = matches.numbers("ref_dbh_cm"), lo = numbers_or_nan(matches, "dbh_lo_cm"),
             hi = numbers_or_nan(matches, "dbh_hi_cm");
  for (std::size_t i = 0; i < kind.size(); ++i) {
    if (kind[i] == "missed") missed += 1;
    if (kind[i] == "false") extra += 1;
    if (kind[i] != "matched") continue;
    matched += 1;
    positions.emplace_back(dx[i], dy[i]);
    diameters.push_back({dbh[i], ref[i], lo[i], hi[i]});
  }
}

PathErrors::PathErrors()
    : poses(no_number),
      length_m(no_number),
      ate_rmse_m(no_number),
      ate_max_m(no_number),
      rpe_translation_m(no_number),
      rpe_rotation_deg(no_number),
      rpe_distance_m(no_number),
      drift_pct(no_number) {}

PathErrors path_errors(const Table& summary) {
  const auto& names = summary.texts("measure");
  const auto values = summary.numbers("value");
  const auto value = [&](const char* name) {
    const auto it = std::ranges::find(names, name);
    return it == names.end() ? no_number : values[static_cast<std::size_t>(it - names.begin())];
  };
  PathErrors p;
  p.poses = value("poses");
  p.length_m = value("length");
  p.ate_rmse_m = value("ate_rmse");
  p.ate_max_m = value("ate_max");
  p.rpe_translation_m = value("rpe_translation_rmse");
  p.rpe_rotation_deg = value("rpe_rotation_rmse");
  p.rpe_distance_m = value("rpe_distance_translation_rmse");
  p.drift_pct = value("drift");
  return p;
}

Table comparison_table(const std::vector<ComparisonRow>& rows) {
  Table t;
  const auto texts = [&](const char* name, std::string ComparisonRow::*member) {
    std::vector<std::string> values;
    for (const auto& r : rows) values.push_back(r.*member);
    t.set(name, std::move(values));
  };
  const auto counts = [&](const char* name, std::int64_t ComparisonRow::*member) {
    std::vector<std::int64_t> values;
    for (const auto& r : rows) values.push_back(r.*member);
    t.set(name, std::move(values));
  };
  texts("scope", &ComparisonRow::scope);
  counts("run", &ComparisonRow::run);
  texts("name", &ComparisonRow::name);
  texts("against", &ComparisonRow::against);
  texts("plot", &ComparisonRow::plot);
  texts("system", &ComparisonRow::system);
  counts("runs", &ComparisonRow::runs);
  const ComparisonRow none;
  std::vector<Numbers> trees, paths;
  for (const auto& r : rows) {
    trees.push_back(tree_numbers(r));
    paths.push_back(path_numbers(r.path));
  }
  if (rows.empty()) {  // the columns of no row
    for (const auto& [name, value] : tree_numbers(none)) t.set(name, std::vector<double>());
    for (const auto& [name, value] : path_numbers(none.path)) t.set(name, std::vector<double>());
  }
  set_numbers(t, trees);
  set_numbers(t, paths);
  for (const auto& [column, measure] : published_columns) {
    std::vector<double> values;
    for (const auto& r : rows)
      values.push_back(
          number_from_text(published_figure(r.published_plot, r.published_system, measure)).value_or(no_number));
    t.set(column, std::move(values));
  }
  return t;
}

}  // namespace bole::evaluation
