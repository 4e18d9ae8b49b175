// Diameters: their distribution, and how they compare with a reference.
#pragma once

#include "cloud/table.h"
#include "render/charts/match_group.h"
#include "render/draw/figure.h"

namespace bole::render {

// Estimated against reference diameter with the 1:1 line. `matches` as the evaluation gives it.
Figure dbh_scatter(const Table& matches, double width_mm);
// Several series in one figure, each in its colour with its statistics. `against`: a run in place of a reference.
Figure dbh_scatter(const std::vector<MatchGroup>& groups, double width_mm, const std::string& against);

// Errors per class of reference diameter: median, quartiles, whiskers to 1.5 times their distance, every error as a
// dot.
Figure dbh_error_boxes(const Table& matches, double width_mm, double class_cm = 4);
// A panel for each series, one below the other, with the same classes and the same range.
Figure dbh_error_boxes(const std::vector<MatchGroup>& groups, double width_mm, double class_cm = 4);

// How many stems per diameter class. `dbh_cm` of the stems that count.
Figure dbh_histogram(const std::vector<double>& dbh_cm, double width_mm, double class_cm = 4);

struct ErrorStatistics {
  std::size_t count = 0;
  double bias = 0, rmse = 0;  // of estimate minus reference
  // Mean and root mean square of error / reference in percent: relBIAS and relRMSE of evaluation.plot.
  double relative_bias_pct = 0, relative_rmse_pct = 0;
  double r_squared = 0;  // squared correlation
};
ErrorStatistics error_statistics(const std::vector<double>& estimate, const std::vector<double>& reference);

}  // namespace bole::render
