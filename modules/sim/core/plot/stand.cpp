#include "sim/core/plot/stand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/option.h"
#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

using std::numbers::pi;

// Stems of a stool leave it at this lean or more.
constexpr double stool_lean_deg = 6, steepest_stool_lean_deg = 13;

// Height over diameter after Naslund: h = 1.3 + d^2 / (a + b d)^2, with coefficients of a middling site.
double height_from_dbh(double dbh_cm) { return 1.3 + dbh_cm * dbh_cm / std::pow(1.2 + 0.185 * dbh_cm, 2); }

Random stand_random(std::uint64_t seed, std::uint64_t purpose, int tree) {
  return {seed, Stream::stand, purpose * 1'000'000 + static_cast<std::uint64_t>(tree)};
}

// A lean of up to 20 deg moves breast height by half a metre: the stem stays on its side of the boundary.
bool may_lean(const Tree& tree, double half_side_m) {
  const double out = tree.stem.foot.head<2>().cwiseAbs().maxCoeff() - half_side_m;
  return tree.in_plot ? out < -0.8 : out > 0.8;
}

Eigen::Vector2d away_from_nearest(const Tree& tree, const std::vector<Tree>& others) {
  Eigen::Vector2d away = Eigen::Vector2d::Zero();
  double nearest = 1e9;
  for (const auto& other : others) {
    const Eigen::Vector2d offset = (tree.stem.foot - other.stem.foot).head<2>();
    if (offset.norm() < nearest && offset.norm() > 0) {
      nearest = offset.norm();
      away = offset;
    }
  }
  return away;
}

}  // namespace

// Scales the stem until the tape reads `dbh_m`.
void fit_radius(Tree& tree, const Terrain& terrain, double dbh_m) {
  tree.stem.radius_m = 0.5 * dbh_m;
  for (int i = 0; i < 20; ++i) {
    tree.taped = tape(tree.stem, terrain);
    const double ratio = dbh_m / tree.taped.diameter_m;
    if (std::abs(ratio - 1) < 1e-9) return;
    tree.stem.radius_m *= ratio;
  }
}

void shape_stem(Tree& tree, const TreeRecipe& recipe, double dbh_cm, Random& random) {
  auto& s = tree.stem;
  s.height_m = std::max(3.0, height_from_dbh(dbh_cm) * random.uniform(0.88, 1.12));
  s.end_m = s.height_m;
  s.taper_exponent = tree.species == Species::conifer ? random.uniform(0.75, 0.95) : random.uniform(0.65, 0.85);
  s.lean = std::tan(radians(recipe.lean_sd_deg)) * Eigen::Vector2d(random.bounded_normal(), random.bounded_normal()) /
           std::numbers::sqrt2;
  s.bow = recipe.sweep_m * random.bounded_normal() * direction_of(random.angle());
  s.bow_length_m = random.uniform(6, 14);
  s.flare = recipe.flare * random.uniform(0.5, 1.5);
  s.flare_length_m = random.uniform(0.2, 0.36);
  for (std::size_t k = 0; k < s.amplitude.size(); ++k) {
    const double order = static_cast<double>(k) + StemShape::first_order;
    s.amplitude[k] = recipe.ovality * random.bounded_normal() * std::pow(2.0 / order, 1.7);
    s.phase[k] = random.angle();
  }
  s.lobes = 3 + random.index(4);
  s.lobe_amplitude = s.flare * random.uniform(0.2, 0.5);
  s.lobe_phase = random.angle();
  s.bark_depth_m = 1e-3 * recipe.bark_mm * random.uniform(0.5, 1.5);
}

TreeRecipe choose_species(Tree& tree, const TreeRecipe& recipe, std::uint64_t seed) {
  tree.species_name = choice_name(tree.species);
  if (recipe.species.empty()) return recipe;
  double total = 0;
  for (const auto& s : recipe.species) total += s.share;
  double left = total * stand_random(seed, 1, tree.id).uniform();
  std::size_t chosen = 0;
  while (chosen + 1 < recipe.species.size() && left >= recipe.species[chosen].share)
    left -= recipe.species[chosen++].share;
  const auto& species = recipe.species[chosen];
  tree.species = species.form;
  tree.species_name = species.name;
  TreeRecipe form = recipe;
  form.bark_mm = species.bark_mm;
  form.ovality = species.ovality;
  form.flare = species.flare;
  return form;
}

void disfigure(Tree& tree, const Forest& forest, std::uint64_t seed) {
  const auto& recipe = forest.recipe.trees;
  auto& s = tree.stem;
  Random random = stand_random(seed, 2, tree.id);
  const bool leans = random.chance(recipe.leaning_share), buttressed = random.chance(recipe.buttress_share);
  const double lean_deg = random.uniform(10, 20), turn = random.uniform(-0.8, 0.8);
  if (leans && may_lean(tree, forest.half_side_m())) {
    const Eigen::Vector2d away = away_from_nearest(tree, forest.trees);
    s.lean = std::tan(radians(lean_deg)) * direction_of(std::atan2(away.y(), away.x()) + turn);
  }
  if (buttressed) {
    s.flare = random.uniform(0.5, 1.0);
    s.flare_length_m = random.uniform(0.5, 0.8);
    s.lobe_amplitude = random.uniform(0.25, 0.5);
  }
}

Stools::Stools(const PlotRecipe& recipe, const std::vector<Site>& sites, const std::vector<double>& dbh_cm,
               std::uint64_t seed)
    : seed_(seed) {
  const double share = recipe.trees.coppice_share, mean_stems = 0.5 * (2 + recipe.trees.coppice_stems);
  if (share <= 0) return;
  places_.resize(dbh_cm.size());
  const double begin = share / (mean_stems - share * (mean_stems - 1)), half = 0.5 * recipe.size_m;
  Random random(seed, Stream::stand);
  for (std::size_t i = 0; i < places_.size();) {
    const auto& middle = sites[i].xy;
    const bool stool = random.chance(begin);
    const int stems = 2 + random.index(recipe.trees.coppice_stems - 1);
    const double turn = random.angle();
    const bool free = middle.cwiseAbs().maxCoeff() < half - 1.2 && middle.norm() > 2;
    if (!stool || !free || i + static_cast<std::size_t>(stems) > places_.size()) {
      ++i;
      continue;
    }
    const auto first = dbh_cm.begin() + static_cast<std::ptrdiff_t>(i);
    const double thickest_m = 0.01 * *std::max_element(first, first + stems);
    // Neighbours stand free at breast height even where both turn towards each other by a tenth of their angle.
    const double apart = (1.1 * thickest_m + 0.04) / (2 * std::sin(0.8 * pi / stems));
    const double radius = std::max(0.6 * thickest_m, apart - 1.2 * std::tan(radians(stool_lean_deg)));
    const std::size_t leader = i;
    for (int k = 0; k < stems; ++k) places_[i++] = {leader, k, stems, radius, turn, middle};
  }
}

bool Stools::join(Tree& tree, std::size_t index) const {
  if (!holds(index)) return false;
  const Place& place = places_[index];
  Random random = stand_random(seed_, 3, tree.id);
  const double spread = 2 * pi / place.stems,
               angle = place.turn_rad + (place.number + random.uniform(-0.1, 0.1)) * spread;
  auto& s = tree.stem;
  s.foot.head<2>() = place.middle + place.radius_m * direction_of(angle);
  s.lean = std::tan(radians(random.uniform(stool_lean_deg, steepest_stool_lean_deg))) * direction_of(angle);
  s.bow *= 0.3;
  s.flare *= 0.5;
  tree.twin_of = place.number == 0 ? 0 : static_cast<int>(place.leader) + 1;
  return true;
}

void add_poles(Forest& forest, std::uint64_t seed) {
  const auto& recipe = forest.recipe;
  const auto& u = recipe.understorey;
  const double half = forest.half_side_m(), reach = half + recipe.buffer_m;
  const auto count = std::lround(u.poles_per_ha * 4 * reach * reach / 1e4);
  Random places(seed, Stream::poles);
  const std::size_t first = forest.trees.size();
  const auto stands_free = [&](const Eigen::Vector2d& p) {
    const double inside = p.cwiseAbs().maxCoeff();
    if (inside > reach || std::abs(inside - half) < 0.3) return false;
    if (p.norm() < 1.2 || (p - Eigen::Vector2d(0, half)).norm() < 1.2) return false;
    return std::ranges::none_of(forest.trees, [&](const Tree& t) {
      const double gap = t.pole ? 0.35 : 0.3 + t.stem.radius_m * (1 + t.stem.flare);
      return (t.stem.foot.head<2>() - p).norm() < gap || (t.stem.axis(1.3).head<2>() - p).norm() < gap;
    });
  };
  for (long i = 0, attempts = 0; i < count && attempts < 200 * count; ++attempts) {
    Eigen::Vector2d p(places.uniform(-reach, reach), places.uniform(-reach, reach));
    const bool in_group = places.chance(recipe.layout.clustering);
    const Eigen::Vector2d step = places.uniform(0.4, 1.4) * direction_of(places.angle());
    const int mother = places.index(static_cast<int>(forest.trees.size() - first) + 1);
    if (in_group && first + static_cast<std::size_t>(mother) < forest.trees.size())
      p = forest.trees[first + static_cast<std::size_t>(mother)].stem.foot.head<2>() + step;
    if (!stands_free(p)) continue;
    ++i;
    Tree tree;
    tree.id = static_cast<int>(forest.trees.size()) + 1;
    tree.pole = true;
    tree.in_plot = p.cwiseAbs().maxCoeff() < half;
    Random random(seed, Stream::poles, static_cast<std::uint64_t>(tree.id));
    tree.species = random.chance(recipe.trees.conifer_share) ? Species::conifer : Species::broadleaf;
    TreeRecipe form = choose_species(tree, recipe.trees, seed);
    // Young bark is smoother, and light is sought by growing straight.
    form.bark_mm *= 0.4;
    form.flare *= 0.5;
    form.lean_sd_deg = std::min(3.0, form.lean_sd_deg);
    form.sweep_m = std::min(0.06, form.sweep_m);
    const double dbh_cm = random.uniform(u.pole_min_cm, u.pole_max_cm);
    tree.stem.foot.head<2>() = p;
    tree.stem.foot.z() = forest.terrain.height(p.x(), p.y());
    shape_stem(tree, form, dbh_cm, random);
    tree.alive = !random.chance(form.dead_share);
    tree.crown_base_h = random.uniform(0.3, 0.6) * tree.stem.height_m;
    fit_radius(tree, forest.terrain, 0.01 * dbh_cm);
    forest.trees.push_back(std::move(tree));
  }
}

}  // namespace bole::sim
