#include "rows/core/rows/row_chains.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/angles.h"
#include "rows/core/rows/line_fit.h"

namespace bole::rows {
namespace {

constexpr std::size_t look_back = 5;       // plants of the chain that tell where it leads
constexpr std::size_t look_back_bent = 8;  // and of one long enough to tell how it bends
constexpr std::size_t bend_from = 7;
constexpr double bend_weight = 3;                // of the direction at the end of a bent chain
constexpr double prior_weight = 2;               // of the local direction, in squared plant spacings
constexpr double across_share = 0.35;            // of the row spacing: never further towards the next row
constexpr double gap_widening = 0.06;            // of the lateral tolerance, in plant spacings per spacing ahead
constexpr double turn_limit = 30 * rad_per_deg;  // between a chain and the pattern beyond a gap
constexpr double gap_from = 1.6;                 // plant spacings: further plants lie beyond a gap
constexpr double min_step = 0.45;                // plant spacings
constexpr double short_chain_fill =
    0.55;  // plants over places of a short chain: fewer are strays that line up by chance
constexpr std::size_t short_chain = 6;

// Where a chain leads at its end.
struct Lead {
  Eigen::Vector2d end, centre, u;  // last plant, a point on the line, unit direction ahead
  double spacing_m, lateral_m;     // plant spacing; tolerance across
};

class Grower {
 public:
  Grower(const Points2& plants, const PlantGrid& grid, const std::vector<LocalPattern>& patterns,
         const RowOptions& options)
      : plants_(plants), grid_(grid), patterns_(patterns), o_(options), taken_(plants.size(), false) {}

  std::vector<Chain> grow(const Run& run) {
    std::vector<Chain> chains;
    for (const int seed : seeds()) {
      run.check_cancel();
      if (taken_[at(seed)]) continue;
      taken_[at(seed)] = true;
      Chain chain{seed};
      extend(chain, +1);
      std::reverse(chain.begin(), chain.end());
      extend(chain, -1);
      if (chain.size() > 1)
        chains.push_back(std::move(chain));
      else
        taken_[at(seed)] = false;  // a later chain may still take it up
    }
    join(chains);
    std::erase_if(chains, [&](const Chain& c) { return !is_row(c); });
    return chains;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const Eigen::Vector2d& plant(int i) const { return plants_[at(i)]; }

  // The clearest first; among equals in order of place, so that the order of the file does not matter.
  std::vector<int> seeds() const {
    std::vector<int> order(plants_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      if (patterns_[at(a)].confidence != patterns_[at(b)].confidence)
        return patterns_[at(a)].confidence > patterns_[at(b)].confidence;
      return std::pair(plant(a).x(), plant(a).y()) < std::pair(plant(b).x(), plant(b).y());
    });
    return order;
  }

  // `sign` tells the way along the seed's direction while the chain is a single plant.
  Lead lead_of(const Chain& chain, int sign) const {
    const auto& pattern = patterns_[at(chain.back())];
    Lead lead;
    lead.end = plant(chain.back());
    lead.spacing_m = pattern.plant_spacing_m;
    lead.lateral_m = std::min(o_.lateral_tolerance * lead.spacing_m, across_share * pattern.row_spacing_m);
    const std::size_t n = std::min(chain.size() >= bend_from ? look_back_bent : look_back, chain.size());
    Points2 last;
    for (std::size_t i = chain.size() - n; i < chain.size(); ++i) last.push_back(plant(chain[i]));
    if (n == 1) {
      lead.centre = lead.end;
      lead.u = sign * Eigen::Vector2d(std::cos(pattern.angle_rad), std::sin(pattern.angle_rad));
      return lead;
    }
    const auto fit = fit_orthogonal(last);
    Eigen::Vector2d u = fit.direction();
    if (u.dot(last.back() - last.front()) < 0) u = -u;
    double along = 0;
    for (const auto& p : last) along += (p - fit.centre).squaredNorm();
    const double own_weight = n >= bend_from ? bend_weight : along / (lead.spacing_m * lead.spacing_m);
    lead.centre = fit.centre;
    double angle = std::atan2(u.y(), u.x());
    if (n >= bend_from) bend(last, u, lead.centre, angle);
    const double turn = std::remainder(pattern.angle_rad - angle, std::numbers::pi);
    if (std::abs(turn) < turn_limit) angle += prior_weight / (prior_weight + own_weight) * turn;
    lead.u = {std::cos(angle), std::sin(angle)};
    return lead;
  }

  // A parabola over the last plants of a chain, in the axes of their line along `u`: place and direction at its end.
  static void bend(const Points2& last, const Eigen::Vector2d& u, Eigen::Vector2d& end, double& angle) {
    const Eigen::Vector2d across(-u.y(), u.x()), centre = end;
    Eigen::MatrixX3d powers(last.size(), 3);
    Eigen::VectorXd offset(last.size());
    const double scale = (last.back() - centre).dot(u);
    for (std::size_t i = 0; i < last.size(); ++i) {
      const double t = (last[i] - centre).dot(u) / scale;
      const auto row = static_cast<Eigen::Index>(i);
      powers.row(row) << 1, t, t * t;
      offset[row] = (last[i] - centre).dot(across);
    }
    const Eigen::Vector3d c = powers.colPivHouseholderQr().solve(offset);
    end = centre + scale * u + c.sum() * across;
    angle += std::atan((c[1] + 2 * c[2]) / scale);
  }

  // What a plant costs as the next of the chain; infinite when it cannot be. 1 for a perfect next plant.
  // `angle_there` is the direction of the row at the candidate.
  double cost(const Lead& lead, int candidate, double angle_there, std::size_t chain_size) const {
    constexpr double no = std::numeric_limits<double>::infinity();
    const double steps = (plant(candidate) - lead.end).dot(lead.u) / lead.spacing_m;
    if (steps < min_step || steps > o_.max_gap + 1.5) return no;
    Eigen::Vector2d u = lead.u;
    if (steps > gap_from || chain_size == 1) {  // beyond a gap another block may begin
      const double angle = std::atan2(u.y(), u.x()), turn = std::remainder(angle_there - angle, std::numbers::pi);
      if (std::abs(turn) > turn_limit) return no;
      // The chord of an arc points half way between the directions at its ends.
      if (steps > gap_from) u = {std::cos(angle + turn / 2), std::sin(angle + turn / 2)};
    }
    const Eigen::Vector2d n(-u.y(), u.x());
    const double across = std::abs((plant(candidate) - lead.centre).dot(n));
    const double tolerance = lead.lateral_m + gap_widening * std::max(0.0, steps - 1) * lead.spacing_m;
    if (across > std::min(tolerance, std::max(lead.lateral_m, across_share * patterns_[at(candidate)].row_spacing_m)))
      return no;
    const double uneven = std::abs(steps - std::max(1.0, std::round(steps)));
    return steps + 2 * uneven + 2 * across * across / (lead.lateral_m * lead.lateral_m);
  }

  int next(const Chain& chain, int sign) const {
    const Lead lead = lead_of(chain, sign);
    int best = -1;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const double reach : {2.2, o_.max_gap + 2.0}) {  // most often the next plant is near
      for (const int j : grid_.within(lead.end, reach * lead.spacing_m)) {
        if (taken_[at(j)]) continue;
        if (const double c = cost(lead, j, patterns_[at(j)].angle_rad, chain.size()); c < best_cost) {
          best = j;
          best_cost = c;
        }
      }
      if (best >= 0 && best_cost <= reach) return best;
    }
    return best;
  }

  void extend(Chain& chain, int sign) {
    for (int j = next(chain, sign); j >= 0; j = next(chain, sign)) {
      chain.push_back(j);
      taken_[at(j)] = true;
    }
  }

  // The chain whose end `a` leads to, -1 when none; `reversed` when its last plant is the nearer one.
  int follower(const std::vector<Chain>& chains, std::size_t a, bool& reversed) const {
    const Lead lead = lead_of(chains[a], +1);
    int best = -1;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < chains.size(); ++b) {
      if (a == b || chains[b].empty()) continue;
      for (const bool back : {false, true}) {
        const int first = back ? chains[b].back() : chains[b].front();
        if ((plant(first) - lead.end).norm() > (o_.max_gap + 2) * lead.spacing_m) continue;
        Chain other = chains[b];
        if (!back) std::reverse(other.begin(), other.end());
        if (other.size() < 2 || chains[a].size() < 2) continue;
        const Eigen::Vector2d back_u = lead_of(other, +1).u;
        if (back_u.dot(lead.u) > -std::cos(turn_limit)) continue;
        const double angle_there = std::atan2(-back_u.y(), -back_u.x());
        if (const double c = cost(lead, first, angle_there, chains[a].size()); c < best_cost)
          best = static_cast<int>(b), best_cost = c, reversed = back;
      }
    }
    return best;
  }

  void join(std::vector<Chain>& chains) const {
    for (std::size_t a = 0; a < chains.size(); ++a)
      for (int end = 0; end < 2; ++end) {
        if (chains[a].empty()) continue;
        bool reversed = false;
        for (int b = follower(chains, a, reversed); b >= 0; b = follower(chains, a, reversed)) {
          auto& other = chains[at(b)];
          if (reversed) std::reverse(other.begin(), other.end());
          chains[a].insert(chains[a].end(), other.begin(), other.end());
          other.clear();
        }
        std::reverse(chains[a].begin(), chains[a].end());
      }
    std::erase_if(chains, [](const Chain& c) { return c.empty(); });
  }

  bool is_row(const Chain& chain) const {
    if (std::ssize(chain) < o_.min_plants) return false;
    if (chain.size() >= short_chain) return true;
    double length = 0, spacing = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      spacing += patterns_[at(chain[i])].plant_spacing_m / static_cast<double>(chain.size());
      if (i > 0) length += (plant(chain[i]) - plant(chain[i - 1])).norm();
    }
    return static_cast<double>(chain.size()) >= short_chain_fill * (length / spacing + 1);
  }

  const Points2& plants_;
  const PlantGrid& grid_;
  const std::vector<LocalPattern>& patterns_;
  const RowOptions& o_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<Chain> grow_chains(const Points2& plants, const PlantGrid& grid, const std::vector<LocalPattern>& patterns,
                               const RowOptions& options, const Run& run) {
  return Grower(plants, grid, patterns, options).grow(run);
}

}  // namespace bole::rows
