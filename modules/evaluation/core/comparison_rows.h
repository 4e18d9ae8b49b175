// Rows of the tables that a comparison of runs prints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "evaluation/core/error_measures.h"
#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

// Errors of trees, from tables of matches (StemEvaluation::matches, with dbh_lo_cm and dbh_hi_cm where known).
struct TreeErrors {
  double matched = 0, missed = 0, extra = 0;
  std::vector<Eigen::Vector2d> positions;
  std::vector<DiameterPair> diameters;
  void add(const Table& matches);
};

// Of a trajectory; NaN where it was not compared.
struct PathErrors {
  PathErrors();
  double poses, length_m, ate_rmse_m, ate_max_m, rpe_translation_m, rpe_rotation_deg, rpe_distance_m, drift_pct;
};
// From the summary of evaluate_trajectory().
PathErrors path_errors(const Table& summary);

struct ComparisonRow {
  // run: one run; plot: the runs of a system on a plot; overall: those of a system on all plots.
  // pair: run minus the run `against`.
  std::string scope, name, against, plot, system;
  std::int64_t run = 0;   // 0 for pooled rows
  std::int64_t runs = 1;  // that are pooled
  bool has_trees = false;
  TreeErrors trees;
  PathErrors path;
  PublishedPlot published_plot = PublishedPlot::none;
  PaperSystem published_system = PaperSystem::improved_loam;
};

// scope, run, name, against, plot, system, runs, reference_trees, matched, missed, extra, completeness_pct,
// correctness_pct, mu_x_m, mu_y_m, sigma_x_m, sigma_y_m, cov_xy_m2 (rho_xy in table 2 of the paper), correlation_xy,
// sigma_max_m, rmse_x_m, rmse_y_m, dbh_trees, dbh_bias_cm, dbh_rel_bias_pct, dbh_rmse_cm, dbh_rel_rmse_pct,
// dbh_interval_coverage_pct, poses, length_m, ate_rmse_m, ate_max_m, rpe_translation_m, rpe_rotation_deg,
// rpe_distance_m, drift_pct, and published_NAME for each of tables 2 and 3.
Table comparison_table(const std::vector<ComparisonRow>& rows);

}  // namespace bole::evaluation
