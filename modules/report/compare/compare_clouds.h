// The points of several runs that their comparison draws: the slices of some trees and the plan of the cloud.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "render/charts/slice_pairs.h"
#include "render/maps/plan_density.h"

namespace bole::report {

// A tree that is looked at in all runs of a plot.
struct ComparedPlace {
  std::string name;
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();
  double reference_dbh_m = 0;  // NaN without a reference
  struct Stem {
    bool found = false;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double dbh_m = 0;  // NaN where it was not measured
  };
  std::vector<Stem> stems;  // of each run of the plot
};

// `most` trees that most of these runs have, at even steps of the order of their diameters: no choice by eye.
// `runs`: rows of the table of runs. `trees`: as evaluation.compare gives them.
std::vector<ComparedPlace> compared_places(const Table& trees, const std::vector<std::size_t>& runs, int most);

struct CompareCloud {
  render::PlanDensity density;  // of the first run of the plot
  PointCloud slice;             // within 5 cm of breast height, about the trees that are looked at
};

// One for each run; empty where it has no cloud, or one without heights above ground. Reads one cloud at a time.
std::vector<CompareCloud> read_compare_clouds(const Table& runs, const std::vector<std::size_t>& of,
                                              const std::vector<ComparedPlace>& places, const PlotArea& area,
                                              const Run& run);

// Empty where no run has points.
std::vector<render::ComparedTree> compared_slices(const std::vector<CompareCloud>& clouds,
                                                  const std::vector<ComparedPlace>& places,
                                                  const std::vector<std::size_t>& runs);

}  // namespace bole::report
