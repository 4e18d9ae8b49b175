// The numbers that a forester reads first: density, basal area, mean diameters, heights and volume of a plot.
#pragma once

#include <vector>

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "inventory/core/inventory_options.h"
#include "inventory/core/stand_values.h"

namespace bole::inventory {

struct DiameterClass {
  double lo_cm = 0, hi_cm = 0;  // lo <= dbh < hi
  std::size_t stems = 0;
  std::size_t to_check = 0;
  double stems_per_ha = 0;  // NaN without a plot area
  double basal_area_m2 = 0;
  double basal_area_m2_per_ha = 0;
  double mean_height_m = 0;  // of the tops that were seen; NaN where none was seen
};

// Of the stems that nobody need look at: measured well, or accepted or edited by a person.
struct SoundValues {
  std::size_t stems = 0;
  double stems_per_ha = 0;
  double basal_area_m2 = 0;
  double basal_area_m2_per_ha = 0;
  double quadratic_mean_dbh_cm = 0;
  double volume_m3 = 0;
};

// A stem that counts, by its row in the table given.
struct CountedStem {
  std::size_t row = 0;
  bool to_check = false;
};

// NaN where a number cannot be given: per-hectare values without a plot area, heights where too few tops were seen.
struct PlotValues {
  double area_m2 = 0;             // horizontal
  double min_counted_dbh_cm = 0;  // thinner stems are not counted
  std::size_t stems = 0;          // centre at breast height inside the plot, thick enough, not rejected
  std::size_t outside = 0;        // measured stems that lie outside
  std::size_t too_thin = 0;       // inside, below the minimum diameter
  double stems_per_ha = 0;
  double basal_area_m2 = 0;  // sum of pi/4 dbh^2
  double basal_area_m2_per_ha = 0;
  double mean_dbh_cm = 0;
  double sd_dbh_cm = 0;              // with n - 1
  double quadratic_mean_dbh_cm = 0;  // sqrt of the mean of dbh^2
  double min_dbh_cm = 0, max_dbh_cm = 0;
  std::size_t tops_seen = 0;   // stems whose top was seen; the height of the others is a lower bound and is not used
  bool heights_known = false;  // enough tops for the heights below, see enough_tops()
  double mean_height_m = 0;
  double lorey_height_m = 0;       // mean height weighted by basal area
  double tops_basal_area_pct = 0;  // share of the basal area whose tops were seen; NaN without stems
  double lorey_at_least_m = 0;     // likewise of all stems, those whose top was not seen with their lower bound;
                                   // NaN where the table has no column of lower bounds
  double dominant_height_m = 0;    // mean height of the 100 thickest stems per hectare; NaN without area, or where less
                                   // than half of their tops were seen
  std::size_t dominant_stems = 0;  // how many stems that is on this plot
  std::size_t dominant_tops = 0;   // how many of their tops were seen
  StandAssumptions assumed;        // what `stand` rests on
  StandValues stand;               // heights of all stems, volume, intervals; without meaning where stems is 0
  std::vector<DiameterClass> classes;
  std::vector<CountedStem> counted;  // in the order of stand.by_stem
  std::size_t to_check = 0;          // of the stems that count; all values above are with them
  SoundValues sound;                 // without them
};

// Whether heights of a plot may be given from so many tops: all of them, or at least 5 and at least a fifth of the
// stems. Below a canopy the few tops that are seen belong to the low trees.
bool enough_tops(std::size_t seen, std::size_t stems);

// Stems that are to be checked are a considerable part from this share of the stems or of the basal area on.
inline constexpr double considerable_share = 0.1;
bool many_to_check(const PlotValues& values);
// More than half of the basal area: what is left does not describe the plot.
bool mostly_to_check(const PlotValues& values);

// `stems`: columns x_m, y_m, dbh_cm, and height_m, height_seen, height_lower_bound_m, quality and state where known. A
// stem is to be checked where its state is "check" or its quality "poor" and no person has decided on it. Breast height
// is that of the table (fact breast_height_m).
PlotValues plot_values(const Table& stems, const CountingRule& rule, const PlotValueOptions& options = {});

}  // namespace bole::inventory
