// What sample plots of different size say about a stand whose trees are all known.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/table.h"

namespace bole::inventory {

// What is done where a sample plot reaches beyond the edge of the stand.
//   ignore   nothing: the trees inside are divided by the whole area of the plot;
//   inside   plots stand only where they fit in as a whole;
//   area     the trees inside are divided by the area inside;
//   mirage   the plot is mirrored at the edge, and trees in the mirror image count again (Schmid-Haas 1969).
enum class EdgeMethod { ignore, inside, area, mirage };
constexpr std::array<std::string_view, 4> choice_names(EdgeMethod) { return {"ignore", "inside", "area", "mirage"}; }

struct SampleOptions {
  std::string radii = "4 6 8 10 12.62 15";
  int plots = 500;
  int seed = 1;
  double distance_bias = 0;
  double distance_sd = 0;
};
const OptionTable& option_table(const SampleOptions*);

struct SampleStudy {
  // A row per radius and method of the edge: radius_m, edge, plots, partial_pct (plots that reach beyond the edge),
  // then for stems per hectare and basal area (m2/ha) the truth, mean, bias_pct, bias_se_pct (standard error of the
  // bias), sd_pct (of single plots), poisson_sd_pct (of trees at random).
  Table summary;
  Table plots;  // a row per plot: radius_m, edge, x_m, y_m, inside_pct, stems, stems_per_ha, basal_area_m2_per_ha
  Report report;
};

// `stems`: x_m, y_m, dbh_cm of all trees; `stand`: the rectangle that is sampled and the least diameter. Plots are
// circles; a tree counts when its centre is within the radius. distance_bias and distance_sd are errors of the measured
// distance from the plot's centre to a tree. The same options give the same plots. Throws Error{bad_input} for a stand
// that is no rectangle or has no trees, and radii that are none or do not fit in; Error{cancelled}.
SampleStudy sample_plots(const Table& stems, const CountingRule& stand, const SampleOptions& options, const Run& run);

// Area of the part of a circle that lies in a rectangle [-width / 2, width / 2] x [-length / 2, length / 2].
double circle_in_rectangle_m2(const Eigen::Vector2d& centre, double radius_m, double width_m, double length_m);

}  // namespace bole::inventory
