#include "sim/core/plot/forest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "base/error.h"
#include "sim/core/plot/layout.h"
#include "sim/core/plot/stand.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

void decide_fate(Tree& tree, const TreeRecipe& recipe, Random& random) {
  auto& s = tree.stem;
  tree.alive = !random.chance(recipe.dead_share);
  const double crown_share = tree.species == Species::conifer ? random.uniform(0.35, 0.55) : random.uniform(0.3, 0.5);
  tree.crown_base_h = crown_share * s.height_m;
  if (!tree.alive && random.chance(0.6)) s.end_m = random.uniform(0.25, 0.7) * s.height_m;
  s.end_m = std::max(s.end_m, 2.5);
  if (tree.alive && random.chance(recipe.fork_share))
    tree.fork_h = random.uniform(2.2, std::max(2.6, 0.6 * s.height_m));
}

// A twin leaves the common base to the other side of its sister: both lean apart enough that they stand free at breast
// height.
void join_twin(Tree& twin, const Tree& sister, Random& random) {
  const Eigen::Vector2d away = direction_of(random.angle());
  const double feet = 0.75 * (sister.stem.radius_m + twin.stem.radius_m);
  twin.stem.foot.head<2>() = sister.stem.foot.head<2>() + feet * away;
  twin.stem.lean = sister.stem.lean + std::tan(radians(random.uniform(7, 12))) * away;
  twin.stem.bow = sister.stem.bow;
  twin.stem.bow_length_m = sister.stem.bow_length_m;
  twin.twin_of = sister.id;
}

std::vector<Target> make_targets(const PlotRecipe& recipe, const Terrain& terrain) {
  const auto on_pole = [&](const char* name, double x, double y) {
    return Target{name, Eigen::Vector3d(x, y, terrain.height(x, y) + 1.5)};
  };
  return {on_pole("centre", 0, 0), on_pole("north", 0, 0.5 * recipe.size_m)};
}

}  // namespace

std::vector<double> exact_sample(int count, double mean, double sd, double min, double max, std::uint64_t seed) {
  Random random(seed, Stream::diameters);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (auto& v : values) v = std::clamp(mean + sd * random.bounded_normal(), min, max);
  if (count < 2) return std::vector<double>(values.size(), mean);
  const auto moments = [&] {
    const double m = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double ss = 0;
    for (const double v : values) ss += (v - m) * (v - m);
    return std::pair(m, std::sqrt(ss / count));
  };
  // Moving to the wanted moments can push values over the limits, clipping moves the moments: repeat until both hold.
  for (int i = 0; i < 500; ++i) {
    const auto [m, s] = moments();
    if (std::abs(m - mean) < 1e-6 && std::abs(s - sd) < 1e-6) break;
    for (auto& v : values) v = std::clamp(mean + (v - m) * (s > 0 ? sd / s : 0), min, max);
  }
  return values;
}

Forest make_forest(const PlotRecipe& recipe, std::uint64_t seed) {
  Forest forest{recipe, Terrain(recipe.terrain, seed), {}, {}};
  const auto& t = recipe.trees;
  std::vector<Site> sites = make_layout(recipe, seed);
  const int inner = static_cast<int>(std::ranges::count_if(sites, &Site::in_plot));
  std::vector<double> dbh = exact_sample(inner, t.dbh_mean_cm, t.dbh_sd_cm, t.dbh_min_cm, t.dbh_max_cm, seed);
  const Stools stools(recipe, sites, dbh, seed);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    Random random(seed, Stream::stem, i);
    const double dbh_cm =
        sites[i].in_plot ? dbh[i] : std::clamp(random.normal(t.dbh_mean_cm, t.dbh_sd_cm), t.dbh_min_cm, t.dbh_max_cm);
    Tree tree;
    tree.id = static_cast<int>(i) + 1;
    tree.in_plot = sites[i].in_plot;
    tree.species = random.chance(t.conifer_share) ? Species::conifer : Species::broadleaf;
    const TreeRecipe form = choose_species(tree, t, seed);
    tree.stem.foot.head<2>() = sites[i].xy;
    shape_stem(tree, form, dbh_cm, random);
    decide_fate(tree, form, random);
    tree.stem.radius_m = 0.005 * dbh_cm;
    const bool in_stool = stools.join(tree, i);
    // The sister is the tree before, when she stands well inside and is no twin herself.
    if (i > 0 && tree.in_plot && random.chance(t.twin_share) && !in_stool && !stools.holds(i - 1)) {
      const Tree& sister = forest.trees.back();
      if (sister.twin_of == 0 && sister.stem.foot.head<2>().cwiseAbs().maxCoeff() < forest.half_side_m() - 1.0 &&
          sister.stem.foot.head<2>().norm() > 2.0)
        join_twin(tree, sister, random);
    }
    if (!in_stool && tree.twin_of == 0) disfigure(tree, forest, seed);
    tree.stem.foot.z() = forest.terrain.height(tree.stem.foot.x(), tree.stem.foot.y());
    fit_radius(tree, forest.terrain, 0.01 * dbh_cm);
    forest.trees.push_back(tree);
  }
  add_poles(forest, seed);
  if (!recipe.is_vineyard()) forest.targets = make_targets(recipe, forest.terrain);
  return forest;
}

}  // namespace bole::sim
