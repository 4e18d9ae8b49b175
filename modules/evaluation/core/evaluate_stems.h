// A stem table held against reference trees.
#pragma once

#include <string>
#include <vector>

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

struct StemEvaluation {
  Table matches;  // kind (matched, missed, false), tree_id, ref_id, x_m, y_m, ref_x_m, ref_y_m, dx_m, dy_m, dbh_cm,
                  // ref_dbh_cm, dbh_error_cm; tree_name and ref_name (text) where ids are no whole numbers; species (of
                  // the reference, else of the stem) where one of both has it
  Table summary;  // measure, value, unit, published
  std::size_t matched = 0, missed = 0, extra = 0;
  std::vector<std::string> warnings;
  std::string guessed_columns;  // of the reference, as the option takes them; empty where none were guessed
};

// Both tables are read by field_table() with the options columns and rows, and need x_m, y_m and dbh_cm. Where the
// reference lacks one and the option reference_columns is empty, its columns are guessed by their headings;
// dbh_lo_cm, dbh_hi_cm and height_m are used where present. One-to-one matching within the distance and diameter gates.
// Reference trees count as `rule` says; a stem is false when it matches no tree at all (counted or not) and counts
// itself. Stems whose state is "rejected" take no part. Rows without a position are left out and told in the warnings.
// Ids that are no whole numbers ("A12", blank) are numbered above the others. Throws Error{bad_input} when a column is
// absent or no row has a position.
//
// Position errors e = estimate - reference (m): mean vector mu, covariance Sigma (divided by n), sigma_max = square
// root of the largest eigenvalue of Sigma, RMSE per axis. Where stems were moved onto the reference, the motion is told
// (align_turn, align_shift_x, align_shift_y): reference = turn (counter-clockwise) of the stem, then shift. DBH errors:
// as diameter_measures() defines them.
StemEvaluation evaluate_stems(const Table& estimate, const Table& reference, const EvaluationOptions& options,
                              const CountingRule& rule);

// A field list in our columns: by reference_columns and reference_rows, else where it lacks one guessed by its
// headings. What was guessed for that goes to `guessed`. Throws Error{bad_input} where nothing can be guessed.
Table reference_in_our_columns(const Table& table, const EvaluationOptions& options, std::string& guessed);

// The columns of `summary`, for whoever adds measures.
class SummaryRows {
 public:
  explicit SummaryRows(PublishedPlot published_plot, PaperSystem published_system = PaperSystem::improved_loam)
      : plot_(published_plot), system_(published_system) {}
  void add(const std::string& measure, double value, const std::string& unit);
  Table table() const;  // fact `published`: whose figures the column has

 private:
  PublishedPlot plot_;
  PaperSystem system_;
  std::vector<std::string> measure_, unit_, published_;
  std::vector<double> value_;
};

}  // namespace bole::evaluation
