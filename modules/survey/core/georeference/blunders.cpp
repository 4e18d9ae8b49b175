#include "survey/core/georeference/blunders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::survey {
namespace {

constexpr double alpha = 0.001;

// Of unit weight, by which limits grow.
struct Unit2 {
  double variance = 1, freedom = std::numeric_limits<double>::infinity();
};

Unit2 unit_of(double chi2, int redundancy, bool sd_stated) {
  if (sd_stated) return {};
  const double freedom = assumed_freedom + redundancy;
  return {(assumed_freedom + chi2) / freedom, freedom};
}

}  // namespace

double f2_limit(double share, double freedom) {
  if (std::isinf(freedom)) return -std::log(share);
  return freedom / 2 * (std::pow(share, -2 / freedom) - 1);
}

std::vector<LeftOut> leave_one_out(const std::vector<PlanPair>& pairs, double scale,
                                   const std::optional<KnownTurn>& known, bool sd_stated) {
  std::vector<LeftOut> all;
  if (pairs.size() < (known ? 2U : 3U)) return all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    auto others = pairs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    LeftOut out;
    const bool apart =
        std::ranges::any_of(others, [&](const auto& p) { return (p.local - others[0].local).norm() > 0; });
    if (!apart && !known) {
      out.limit_m = std::numeric_limits<double>::infinity();
      all.push_back(out);
      continue;
    }
    const auto fit = fit_plan(others, scale, known);
    const auto unit = unit_of(fit.chi2, fit.redundancy, sd_stated);
    const Eigen::Vector2d off = pairs[i].global - fit.to_global(pairs[i].local);
    // Along the line to the centre only the shift is uncertain, across it the turn as well.
    const Eigen::Vector2d arm = fit.to_global(pairs[i].local) - fit.centre_global;
    const double along2 = pairs[i].sd_m * pairs[i].sd_m + fit.shift_se_m * fit.shift_se_m,
                 across2 = along2 + arm.squaredNorm() * fit.turn_se_rad * fit.turn_se_rad;
    const double off_along = arm.norm() > 0 ? off.dot(arm) / arm.norm() : off.norm();
    const double off_across2 = std::max(0.0, off.squaredNorm() - off_along * off_along);
    const double t2 = off_along * off_along / along2 + off_across2 / across2;
    out.distance_m = off.norm();
    const double limit2 = 2 * unit.variance * f2_limit(alpha / static_cast<double>(pairs.size()), unit.freedom);
    out.limit_m = t2 > 0 ? off.norm() * std::sqrt(limit2 / t2) : std::sqrt(limit2 * along2);
    out.others_chi2 = fit.chi2;
    out.others_redundancy = fit.redundancy;
    all.push_back(out);
  }
  return all;
}

Snooped snoop(const std::vector<LeftOut>& points) {
  Snooped found;
  double most = 1;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double ratio = points[i].distance_m / points[i].limit_m; ratio > most) {
      most = ratio;
      found.worst = static_cast<int>(i);
    }
  if (found.worst < 0) return found;
  const auto& worst = points[static_cast<std::size_t>(found.worst)];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<int>(i) == found.worst || !points[i].beyond()) continue;
    // Without redundancy the others cannot contradict; else this point explains as much when what is left without it
    // is no larger than chance.
    const double freedom = points[i].others_redundancy;
    const double chance = freedom + 3 * std::sqrt(2 * std::max(1.0, freedom));
    if (freedom <= 0 || points[i].others_chi2 <= std::max(chance, 4 * worst.others_chi2))
      found.also.push_back(static_cast<int>(i));
  }
  return found;
}

}  // namespace bole::survey
