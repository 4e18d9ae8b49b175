// Where the trees of a plot stand and what they are like: everything that is known before any mesh is made.
#pragma once

#include <string>
#include <vector>

#include "sim/core/plot/recipe.h"
#include "sim/core/plot/stem_shape.h"
#include "sim/core/plot/terrain.h"

namespace bole::sim {

struct Tree {
  int id = 0;  // from 1
  Species species = Species::broadleaf;
  std::string species_name;  // of the recipe's species; the form where it names none
  bool alive = true;
  bool in_plot = true;
  bool pole = false;        // of the understorey: not among the recipe's trees.count
  int twin_of = 0;          // id of the tree whose base it shares; 0: none
  double fork_h = 0;        // height of a fork above breast height; 0: none
  double crown_base_h = 6;  // height of the lowest living branch
  StemShape stem;
  TapedStem taped;
};

// A cylinder of retro-reflective foil around a pole.
struct Target {
  std::string name;  // centre, north
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double radius_m = 0.10, height_m = 0.30;
};

struct Forest {
  PlotRecipe recipe;
  Terrain terrain;
  std::vector<Tree> trees;  // those of the plot, those around it, then the poles
  std::vector<Target> targets;

  double half_side_m() const { return 0.5 * recipe.size_m; }
};

// Lays the plot out. The diameters of the trees within the plot have the recipe's mean and SD exactly (to 0.01 cm).
// Throws Error{bad_input} when the trees do not fit at the recipe's spacing.
Forest make_forest(const PlotRecipe& recipe, std::uint64_t seed);

// `count` normal deviates within [min, max] whose sample mean and SD (divided by n) are those asked for.
std::vector<double> exact_sample(int count, double mean, double sd, double min, double max, std::uint64_t seed);

}  // namespace bole::sim
