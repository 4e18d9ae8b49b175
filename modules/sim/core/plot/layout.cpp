#include "sim/core/plot/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "sim/core/field/vineyard.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

constexpr double boundary_gap_m = 0.3;
constexpr double target_gap_m = 1.2;

bool inside(const Eigen::Vector2d& p, double half) { return std::max(std::abs(p.x()), std::abs(p.y())) <= half; }

bool near_target(const Eigen::Vector2d& p, double half) {
  return p.norm() < target_gap_m || (p - Eigen::Vector2d(0, half)).norm() < target_gap_m;
}

class Scatter {
 public:
  Scatter(const PlotRecipe& recipe, std::uint64_t seed)
      : recipe_(recipe), random_(seed, Stream::layout), half_(0.5 * recipe.size_m), outer_(half_ + recipe.buffer_m) {}

  // Throws darts until `count` more sites stand; false when the region is full.
  bool add(int count, bool in_plot) {
    const std::size_t wanted = sites_.size() + static_cast<std::size_t>(count);
    for (int attempt = 0; sites_.size() < wanted; ++attempt) {
      if (attempt > 2000 * count) return false;
      const Eigen::Vector2d p = candidate(in_plot);
      if (allowed(p, in_plot)) sites_.push_back({p, in_plot});
    }
    return true;
  }
  std::vector<Site> take() { return std::move(sites_); }

 private:
  Eigen::Vector2d candidate(bool in_plot) {
    const double reach = in_plot ? half_ : outer_;
    if (!sites_.empty() && random_.chance(recipe_.layout.clustering)) {
      const auto& mother = sites_[static_cast<std::size_t>(random_.index(static_cast<int>(sites_.size())))].xy;
      const double angle = random_.angle(), distance = recipe_.layout.min_spacing_m * random_.uniform(1.0, 2.0);
      return mother + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    const double x = random_.uniform(-reach, reach);
    return {x, random_.uniform(-reach, reach)};
  }
  bool allowed(const Eigen::Vector2d& p, bool in_plot) const {
    if (in_plot ? !inside(p, half_ - boundary_gap_m) : (inside(p, half_ + boundary_gap_m) || !inside(p, outer_)))
      return false;
    if (near_target(p, half_)) return false;
    return std::ranges::none_of(sites_,
                                [&](const Site& s) { return (s.xy - p).norm() < recipe_.layout.min_spacing_m; });
  }

  const PlotRecipe& recipe_;
  Random random_;
  double half_, outer_;
  std::vector<Site> sites_;
};

std::vector<Site> natural_layout(const PlotRecipe& recipe, std::uint64_t seed) {
  const double half = 0.5 * recipe.size_m, outer = half + recipe.buffer_m;
  const double share = (outer * outer - half * half) / (half * half);
  Scatter scatter(recipe, seed);
  if (!scatter.add(recipe.trees.count, true))
    throw bad_input("recipe '" + recipe.name + "': " + std::to_string(recipe.trees.count) + " trees do not fit in " +
                        number_text(recipe.size_m) + " m x " + number_text(recipe.size_m) + " m at a spacing of " +
                        number_text(recipe.layout.min_spacing_m) + " m",
                    "a plot they fit in", "Lower trees.count or layout.min_spacing_m");
  // The buffer may stay thinner than the plot: nothing is measured there.
  scatter.add(static_cast<int>(std::lround(recipe.trees.count * share)), false);
  return scatter.take();
}

// Trees about the block, none within and none in a shed.
std::vector<Site> vineyard_surroundings(const PlotRecipe& recipe, std::uint64_t seed) {
  Scatter scatter(recipe, seed);
  scatter.add(recipe.trees.count, false);
  auto sites = scatter.take();
  const auto sheds = shed_places(recipe);
  std::erase_if(sites, [&](const Site& s) {
    return std::ranges::any_of(sheds, [&](const auto& at) { return (at - s.xy).norm() < shed_reach_m; });
  });
  return sites;
}

std::vector<Site> row_layout(const PlotRecipe& recipe, std::uint64_t seed) {
  const auto& l = recipe.layout;
  const double half = 0.5 * recipe.size_m, outer = half + recipe.buffer_m, reach = outer * std::numbers::sqrt2;
  const double azimuth = radians(l.row_azimuth_deg);
  const Eigen::Vector2d along(std::sin(azimuth), std::cos(azimuth)), across(along.y(), -along.x());
  Random random(seed, Stream::layout);
  std::vector<Site> inner, buffer;
  for (int row = -static_cast<int>(reach / l.row_spacing_m) - 1; row * l.row_spacing_m < reach; ++row)
    for (int plant = -static_cast<int>(reach / l.plant_spacing_m) - 1; plant * l.plant_spacing_m < reach; ++plant) {
      const Eigen::Vector2d jitter(random.bounded_normal(), random.bounded_normal());
      const bool missing = random.chance(l.missing_share);
      // Half a row aside, so that a walking lane runs through the centre.
      const Eigen::Vector2d p =
          (row + 0.5) * l.row_spacing_m * across + plant * l.plant_spacing_m * along + l.position_sd_m * jitter;
      if (missing || near_target(p, half) || !inside(p, outer)) continue;
      if (inside(p, half - boundary_gap_m))
        inner.push_back({p, true});
      else if (!inside(p, half + boundary_gap_m))
        buffer.push_back({p, false});
    }
  const int wanted = recipe.trees.count > 0 ? recipe.trees.count : static_cast<int>(inner.size());
  if (static_cast<int>(inner.size()) < std::max(1, wanted))
    throw bad_input(
        "recipe '" + recipe.name + "': the rows hold " + std::to_string(inner.size()) + " plants within the plot",
        "at least " + std::to_string(std::max(1, wanted)) + " (trees.count)", "Lower trees.count or the spacings");
  // Plants too many are left out at random places, as gaps in the rows.
  while (static_cast<int>(inner.size()) > wanted)
    inner.erase(inner.begin() + random.index(static_cast<int>(inner.size())));
  inner.insert(inner.end(), buffer.begin(), buffer.end());
  return inner;
}

}  // namespace

std::vector<Site> make_layout(const PlotRecipe& recipe, std::uint64_t seed) {
  if (recipe.is_vineyard()) return vineyard_surroundings(recipe, seed);
  return recipe.layout.kind == LayoutKind::rows ? row_layout(recipe, seed) : natural_layout(recipe, seed);
}

}  // namespace bole::sim
