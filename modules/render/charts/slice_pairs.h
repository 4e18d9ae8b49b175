// The breast-height slices of the same trees in several runs, side by side.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "render/charts/slice_panels.h"
#include "render/draw/figure.h"

namespace bole::render {

// One tree in one run. The panel's centre is where this run put the stem.
struct ComparedSlice {
  SlicePanel panel;
  bool found = true;                                       // this run has the tree
  Eigen::Vector2d to_reference = Eigen::Vector2d::Zero();  // from the centre, metres
};

struct ComparedTree {
  std::string name;                   // of the tree
  double reference_dbh_m = 0;         // NaN where there is none
  std::vector<ComparedSlice> slices;  // of each run, in the order of the names
};

struct SliceRun {
  std::string name;
  Color color;
};

// Points in grey, the circle that each run fitted in its colour, the reference dashed. All panels of a tree have one
// scale.
Figure slices_side_by_side(const std::vector<SliceRun>& runs, const std::vector<ComparedTree>& trees, double width_mm);

}  // namespace bole::render
