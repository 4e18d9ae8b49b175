// What makes a stand harder to measure than even, upright, single stems: species with bark of their own, buttresses,
// leaning stems, stools, poles below the canopy.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/plot/forest.h"
#include "sim/core/plot/layout.h"
#include "sim/core/scene/random.h"

namespace bole::sim {

// Form of a stem of this diameter, drawn from the recipe's spreads.
void shape_stem(Tree& tree, const TreeRecipe& recipe, double dbh_cm, Random& random);
// Scales the stem until the tape reads `dbh_m`.
void fit_radius(Tree& tree, const Terrain& terrain, double dbh_m);

// Names the species of the tree, and returns the recipe with the bark and the form of that species.
TreeRecipe choose_species(Tree& tree, const TreeRecipe& recipe, std::uint64_t seed);

// Makes a share of the stems lean, away from their nearest neighbour, and gives a share of them buttresses. The foot
// must be set.
void disfigure(Tree& tree, const Forest& forest, std::uint64_t seed);

// Stools of a coppice: runs of trees within the plot that leave one base.
class Stools {
 public:
  Stools(const PlotRecipe& recipe, const std::vector<Site>& sites, const std::vector<double>& dbh_cm,
         std::uint64_t seed);

  bool holds(std::size_t tree) const { return tree < places_.size() && places_[tree].stems > 0; }
  // Moves a tree of a stool to its place there; false when it stands by itself.
  bool join(Tree& tree, std::size_t index) const;

 private:
  struct Place {
    std::size_t leader = 0;
    int number = 0, stems = 0;  // number within the stool; stems 0: no stool
    double radius_m = 0, turn_rad = 0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  };
  std::vector<Place> places_;
  std::uint64_t seed_;
};

// Young trees at random places and in groups, behind the others in forest.trees.
void add_poles(Forest& forest, std::uint64_t seed);

}  // namespace bole::sim
