// The numbers that a forester reads first: density, basal area, mean diameters and heights of a plot.
#pragma once

#include <string>
#include <vector>

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "report/core/stand_values.h"

namespace bole::report {

struct DiameterClass {
  double lo_cm = 0, hi_cm = 0;  // lo <= dbh < hi
  std::size_t stems = 0;
  double stems_per_ha = 0;  // NaN without a plot area
  double basal_area_m2 = 0;
  double basal_area_m2_per_ha = 0;
  double mean_height_m = 0;  // of the tops that were seen; NaN when none was
};

// NaN where a number cannot be had: per-hectare values without a plot area, heights where too few tops were seen.
struct PlotMetrics {
  double area_m2 = 0;        // horizontal
  std::size_t stems = 0;     // centre at breast height inside the plot, thick enough, not rejected
  std::size_t outside = 0;   // measured stems that lie outside
  std::size_t too_thin = 0;  // inside, below the least diameter
  double stems_per_ha = 0;
  double basal_area_m2 = 0;  // sum of pi/4 dbh^2
  double basal_area_m2_per_ha = 0;
  double mean_dbh_cm = 0;
  double sd_dbh_cm = 0;              // with n - 1
  double quadratic_mean_dbh_cm = 0;  // sqrt of the mean of dbh^2
  double least_dbh_cm = 0, most_dbh_cm = 0;
  std::size_t tops_seen = 0;   // stems whose top was seen; the height of the others is a lower bound and counts nowhere
  bool heights_known = false;  // enough tops for the heights below, see enough_tops()
  double mean_height_m = 0;
  double lorey_height_m = 0;       // mean height weighted by basal area
  double dominant_height_m = 0;    // mean height of the 100 thickest stems per hectare; NaN without area, or when less
                                   // than half of their tops were seen
  std::size_t dominant_stems = 0;  // how many stems that is on this plot
  std::size_t dominant_tops = 0;   // how many of their tops were seen
  StandAssumptions assumed;        // what `stand` rests on
  StandValues stand;               // heights of all stems, volume, intervals; without meaning where stems is 0
  std::vector<DiameterClass> classes;
};

// Whether heights of a plot may be told from so many tops: all of them, or at least 5 and at least a fifth of the
// stems. Below a canopy the few tops that are seen belong to the low trees.
bool enough_tops(std::size_t seen, std::size_t stems);

// Heights by row, NaN where the top was not seen: column height_m where height_seen is not 0, all where it is absent.
std::vector<double> seen_heights(const Table& stems);

// `stems`: columns x_m, y_m, dbh_cm, and height_m, height_seen and state where known.
// Breast height is that of the table. `form_sd_pct`: see StandAssumptions.
PlotMetrics plot_metrics(const Table& stems, const CountingRule& rule, double class_cm = 4,
                         double form_sd_pct = usual_form_sd_pct);

// The rows of `stems` that count in plot_metrics().
std::vector<std::size_t> counted_stems(const Table& stems, const CountingRule& rule);

// The metrics as a person reads them.
struct MetricRow {
  std::string name, value, unit, how;
};
std::vector<MetricRow> metric_rows(const PlotMetrics& metrics, double min_dbh_cm);

}  // namespace bole::report
