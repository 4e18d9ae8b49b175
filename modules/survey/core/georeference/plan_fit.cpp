#include "survey/core/georeference/plan_fit.h"

#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"

namespace bole::survey {
namespace {

double plan_weight(const PlanPair& p) { return 1 / (p.sd_m * p.sd_m); }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

// About the centres of weight.
struct Sums {
  double weight = 0, dot = 0, cross = 0, spread = 0;
  Eigen::Vector2d local = Eigen::Vector2d::Zero(), global = Eigen::Vector2d::Zero();
};

Sums sums_of(const std::vector<PlanPair>& pairs) {
  Sums s;
  for (const auto& p : pairs) {
    const double w = plan_weight(p);
    s.weight += w;
    s.local += w * p.local;
    s.global += w * p.global;
  }
  s.local /= s.weight;
  s.global /= s.weight;
  for (const auto& p : pairs) {
    const double w = plan_weight(p);
    const Eigen::Vector2d a = p.local - s.local, b = p.global - s.global;
    s.dot += w * a.dot(b);
    s.cross += w * cross(a, b);
    s.spread += w * a.squaredNorm();
  }
  return s;
}

// The turn at which -scale (dot cos + cross sin) + (turn - known)^2 / (2 sd^2) is smallest.
double best_turn(const Sums& s, double scale, const std::optional<KnownTurn>& known) {
  const double free = std::atan2(s.cross, s.dot), strength = scale * std::hypot(s.cross, s.dot);
  if (!known) return free;
  const double w = 1 / (known->sd_rad * known->sd_rad), apart = wrapped(known->turn_rad - free);
  double d = apart * w / (w + strength);
  constexpr int steps = 20;
  for (int i = 0; i < steps; ++i) {
    const double slope = strength * std::sin(d) + w * (d - apart), bend = strength * std::cos(d) + w;
    if (!(bend > 0)) break;
    d -= slope / bend;
  }
  return wrapped(free + d);
}

}  // namespace

Eigen::Vector2d PlanFit::to_global(const Eigen::Vector2d& local) const {
  return centre_global + scale * turned(local - centre_local, turn_rad);
}

PlanFit fit_plan(const std::vector<PlanPair>& pairs, double scale, const std::optional<KnownTurn>& known) {
  if (pairs.empty()) throw bad_input("there is no control point", "at least two, or one and a bearing");
  const Sums s = sums_of(pairs);
  const double turn_weight = scale * scale * s.spread + (known ? 1 / (known->sd_rad * known->sd_rad) : 0);
  if (!(turn_weight > 0))
    throw bad_input("the control points are all at one place, so that the turn of the plot is not known",
                    "two points apart from one another, or one and a bearing", "Measure a second point or set bearing");
  PlanFit fit;
  fit.scale = scale;
  fit.centre_local = s.local;
  fit.centre_global = s.global;
  fit.turn_rad = best_turn(s, scale, known);
  fit.turn_se_rad = 1 / std::sqrt(turn_weight);
  fit.shift_se_m = 1 / std::sqrt(s.weight);
  for (const auto& p : pairs) {
    fit.residuals.push_back(p.global - fit.to_global(p.local));
    fit.chi2 += fit.residuals.back().squaredNorm() * plan_weight(p);
  }
  if (known) {
    const double off = wrapped(fit.turn_rad - known->turn_rad) / known->sd_rad;
    fit.chi2 += off * off;
  }
  fit.redundancy = 2 * static_cast<int>(pairs.size()) + (known ? 1 : 0) - 3;
  fit.free_scale = s.spread > 0 ? std::hypot(s.dot, s.cross) / s.spread : no_number;
  fit.free_scale_se = s.spread > 0 ? 1 / std::sqrt(s.spread) : no_number;
  return fit;
}

double mirrored_rms_m(const std::vector<PlanPair>& pairs) {
  auto mirrored = pairs;
  for (auto& p : mirrored) p.local.y() = -p.local.y();
  const auto fit = fit_plan(mirrored);
  double sum = 0;
  for (const auto& r : fit.residuals) sum += r.squaredNorm();
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace bole::survey
