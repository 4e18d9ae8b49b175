#include "rows/core/rows/local_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/angles.h"
#include "rows/core/rows/line_fit.h"
#include "rows/core/rows/median_or.h"

namespace bole::rows {
namespace {

using std::numbers::pi;
constexpr int bins = 180;
constexpr int window_plants = 20, pair_neighbours = 10, spacing_neighbours = 24;
constexpr double kernel_deg = 6, refine_deg = 18, cone_deg = 15;
constexpr double too_near = 0.4;  // of the usual nearest distance: forked trees and double detections do not vote

struct Vote {
  double angle_rad, weight;
};

const std::array<double, bins>& kernel() {
  static const auto values = [] {
    std::array<double, bins> k{};
    for (int i = 0; i < bins; ++i) {
      const double d = std::min(i, bins - i);
      k[static_cast<std::size_t>(i)] = std::exp(-d * d / (2 * kernel_deg * kernel_deg));
    }
    return k;
  }();
  return values;
}

// The peak of the votes modulo pi, and the share of the weight within refine_deg of it.
std::pair<double, double> peak_of(const std::vector<Vote>& votes) {
  std::array<double, bins> raw{}, smooth{};
  double all = 0;
  for (const auto& v : votes) {
    const double degrees = v.angle_rad / rad_per_deg;  // (-90, 90]
    raw[static_cast<std::size_t>((static_cast<int>(std::floor(degrees)) + 2 * bins) % bins)] += v.weight;
    all += v.weight;
  }
  for (int i = 0; i < bins; ++i)
    for (int j = 0; j < bins; ++j)
      if (raw[static_cast<std::size_t>(j)] > 0)
        smooth[static_cast<std::size_t>(i)] +=
            raw[static_cast<std::size_t>(j)] * kernel()[static_cast<std::size_t>(std::abs(i - j))];
  const auto best = std::max_element(smooth.begin(), smooth.end()) - smooth.begin();
  double angle = row_angle((static_cast<double>(best) + 0.5) * rad_per_deg), share = 0;
  for (int round = 0; round < 4; ++round) {
    double sum = 0, weight = 0;
    for (const auto& v : votes) {
      const double d = std::remainder(v.angle_rad - angle, pi);
      if (std::abs(d) <= refine_deg * rad_per_deg) {
        sum += v.weight * d;
        weight += v.weight;
      }
    }
    if (weight > 0) angle = row_angle(angle + sum / weight);
    share = all > 0 ? weight / all : 0;
  }
  return {angle, share};
}

class PatternFinder {
 public:
  PatternFinder(const Points2& plants, const PlantGrid& grid, const RowOptions& options)
      : plants_(plants), options_(options) {
    near_.reserve(plants.size());
    for (int i = 0; i < static_cast<int>(plants.size()); ++i) near_.push_back(grid.nearest(i, spacing_neighbours));
  }

  std::vector<int> window(int i) const {
    const auto& near = near_[static_cast<std::size_t>(i)];
    std::vector<int> w{i};
    w.insert(w.end(), near.begin(), near.begin() + std::min<std::ptrdiff_t>(window_plants, std::ssize(near)));
    return w;
  }

  void find_direction(int i, LocalPattern& pattern) const {
    if (options_.direction_deg) {
      pattern.angle_rad = row_angle(*options_.direction_deg * rad_per_deg);
      pattern.confidence = 1;
      return;
    }
    const auto around = window(i);
    std::vector<double> nearest;
    for (const int j : around) nearest.push_back(distance(j, near_[static_cast<std::size_t>(j)].front()));
    const double usual = std::max(median_or(nearest, 1), 1e-9);
    std::vector<Vote> votes;
    for (const int j : around) {
      const auto& near = near_[static_cast<std::size_t>(j)];
      for (std::size_t k = 0; k < near.size() && k < pair_neighbours; ++k) {
        const Eigen::Vector2d d = plants_[static_cast<std::size_t>(near[k])] - plants_[static_cast<std::size_t>(j)];
        const double r = d.norm() / usual;
        if (r > too_near) votes.push_back({row_angle(std::atan2(d.y(), d.x())), std::min(1.0, 1 / (r * r))});
      }
    }
    std::tie(pattern.angle_rad, pattern.confidence) = peak_of(votes);
  }

  // Nearest plants along the direction, before and behind, and across it, of the plants around.
  void find_spacings(int i, LocalPattern& pattern) const {
    const Eigen::Vector2d u(std::cos(pattern.angle_rad), std::sin(pattern.angle_rad)), n(-u.y(), u.x());
    const double slope = std::tan(cone_deg * rad_per_deg);
    std::vector<double> steps;
    for (const int j : window(i)) {
      double ahead = inf, behind = inf;
      for (const int k : near_[static_cast<std::size_t>(j)]) {
        const Eigen::Vector2d d = plants_[static_cast<std::size_t>(k)] - plants_[static_cast<std::size_t>(j)];
        const double along = d.dot(u), across = std::abs(d.dot(n));
        if (across > slope * std::abs(along)) continue;
        (along > 0 ? ahead : behind) = std::min(along > 0 ? ahead : behind, std::abs(along));
      }
      for (const double s : {ahead, behind})
        if (std::isfinite(s)) steps.push_back(s);
    }
    const double nearest = distance(i, near_[static_cast<std::size_t>(i)].front());
    pattern.plant_spacing_m =
        std::max(options_.plant_spacing ? *options_.plant_spacing : median_or(steps, nearest), 1e-9);
    if (options_.row_spacing) {
      pattern.row_spacing_m = *options_.row_spacing;
      return;
    }
    std::vector<double> gaps;
    for (const int j : window(i)) {
      double left = inf, right = inf;
      for (const int k : near_[static_cast<std::size_t>(j)]) {
        const Eigen::Vector2d d = plants_[static_cast<std::size_t>(k)] - plants_[static_cast<std::size_t>(j)];
        const double along = std::abs(d.dot(u)), across = d.dot(n);
        if (along > 0.75 * pattern.plant_spacing_m || std::abs(across) < 0.4 * pattern.plant_spacing_m) continue;
        (across > 0 ? left : right) = std::min(across > 0 ? left : right, std::abs(across));
      }
      for (const double g : {left, right})
        if (std::isfinite(g)) gaps.push_back(g);
    }
    pattern.row_spacing_m = median_or(gaps, inf);
  }

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
  double distance(int a, int b) const {
    return (plants_[static_cast<std::size_t>(a)] - plants_[static_cast<std::size_t>(b)]).norm();
  }
  const Points2& plants_;
  const RowOptions& options_;
  std::vector<std::vector<int>> near_;
};

}  // namespace

std::vector<LocalPattern> local_patterns(const Points2& plants, const PlantGrid& grid, const RowOptions& options,
                                         const Run& run) {
  std::vector<LocalPattern> patterns(plants.size());
  const PatternFinder finder(plants, grid, options);
  for (std::size_t i = 0; i < plants.size(); ++i) {
    if (i % 256 == 0) run.check_cancel();
    finder.find_direction(static_cast<int>(i), patterns[i]);
    finder.find_spacings(static_cast<int>(i), patterns[i]);
  }
  return patterns;
}

}  // namespace bole::rows
