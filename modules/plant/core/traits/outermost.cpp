#include "plant/core/traits/outermost.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::plant {
namespace {

constexpr int directions = 40;
constexpr double apart = 0.008;       // metres
constexpr double inside = 0.012;      // metres that a tip may be inside of the hull
constexpr double top_range = 0.025;   // below the highest point; other tips may be higher in truth
constexpr double tip_floor = 0.0003;  // what colour and blur leave open at a tip

void add(std::vector<TipQuery>& out, std::size_t begin, const TipQuery& q) {
  for (std::size_t i = begin; i < out.size(); ++i)
    if ((out[i].point - q.point).norm() < apart) return;
  out.push_back(q);
}

bool is_top(const TipQuery& q) { return q.direction.z() > 0.9; }

}  // namespace

std::vector<TipQuery> outermost_points(const Points3& plant, const Extents& extents) {
  std::vector<TipQuery> out;
  if (plant.empty()) return out;
  // Tops from the highest down.
  Points3 high;
  for (const auto& p : plant)
    if (p.z() <= extents.top.raw && p.z() > extents.top.raw - top_range) high.push_back(p);
  std::ranges::sort(high, [](const auto& a, const auto& b) { return a.z() > b.z(); });
  for (const auto& p : high) {
    if (out.size() >= 5) break;
    bool below = false;  // the slope of a tip that is already there
    for (const auto& q : out) below = below || (q.point - p).norm() < 2 * apart;
    if (!below) out.push_back({p, Eigen::Vector3d::UnitZ()});
  }
  const std::size_t begin = out.size();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& c : extents.rectangle.corners) middle += c / 4;
  std::vector<const Eigen::Vector3d*> far(directions, nullptr), wide(directions, nullptr);
  const auto at = [](int k) {
    const double turn = 2 * std::numbers::pi * k / directions;
    return Eigen::Vector2d(std::cos(turn), std::sin(turn));
  };
  // Stray points that the extents left out lie outside of the rectangle.
  const Eigen::Vector2d ex = (extents.rectangle.corners[1] - extents.rectangle.corners[0]) / 2,
                        ey = (extents.rectangle.corners[2] - extents.rectangle.corners[1]) / 2;
  const double lx = std::max(ex.norm(), 1e-9), ly = std::max(ey.norm(), 1e-9);
  for (const auto& p : plant) {
    const Eigen::Vector2d d = p.head<2>() - middle;
    if (std::abs(d.dot(ex)) > 1.0001 * lx * lx || std::abs(d.dot(ey)) > 1.0001 * ly * ly) continue;
    for (int k = 0; k < directions; ++k)
      if (auto& best = far[static_cast<std::size_t>(k)];
          best == nullptr || d.dot(at(k)) > (best->head<2>() - middle).dot(at(k)))
        best = &p;
    const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 1;
    auto& best = wide[static_cast<std::size_t>(turn * directions) % directions];
    if (best == nullptr || d.norm() > (best->head<2>() - middle).norm()) best = &p;
  }
  for (int k = 0; k < directions; ++k)
    for (const auto* p : {far[static_cast<std::size_t>(k)], wide[static_cast<std::size_t>(k)]}) {
      if (p == nullptr) continue;
      const Eigen::Vector2d d = p->head<2>() - middle;
      // Tips well inside of the hull cannot become part of it.
      const Eigen::Vector2d out_of = d.normalized();
      double support = 0;
      for (const auto* h : far)
        if (h != nullptr) support = std::max(support, (h->head<2>() - middle).dot(out_of));
      if (support - d.norm() > inside) continue;
      const Eigen::Vector2d u = d.normalized();
      add(out, begin, {*p, Eigen::Vector3d(u.x(), u.y(), 0)});
    }
  return out;
}

std::size_t correct_extents(Extents& extents, const std::vector<TipQuery>& queries, const std::vector<FoundTip>& tips) {
  std::size_t seen = 0;
  for (const auto& t : tips) seen += t.views > 0 || t.floater;
  const auto place = [&](std::size_t k, const Extent& e, double share) -> Eigen::Vector3d {
    const double gain = tips[k].views > 0 ? tips[k].gain : share * (e.value - e.raw);
    return queries[k].point + gain * queries[k].direction;
  };
  // The top: only where the pictures show it.
  double top = -1e9, top_sd = 0;
  bool top_seen = false;
  std::vector<Eigen::Vector2d> plan;
  double plan_sd = 0, plan_count = 0;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    if (tips[k].floater) continue;
    if (is_top(queries[k])) {
      const double z = place(k, extents.top, 1).z();
      if (z > top) {
        top = z;
        top_seen = tips[k].views > 0;
        top_sd = tips[k].sd;
        extents.top_point = queries[k].point;
      }
      continue;
    }
    plan.emplace_back(place(k, extents.length, 0.5).head<2>());
    if (tips[k].views == 0) continue;
    plan_sd += tips[k].sd * tips[k].sd;
    plan_count += 1;
  }
  if (top_seen) {
    extents.top_seen = true;
    extents.top.value = top;
    extents.top.sd = std::hypot(top_sd, tip_floor);
  }
  if (plan.size() >= 4 && 2 * plan_count >= static_cast<double>(plan.size())) {
    const auto rectangle = smallest_rectangle(plan);
    if (rectangle.length > 0) {
      // Two tips carry each side; a tip's own error is the usual one of them.
      const double sd = std::sqrt(2.0) * std::hypot(std::sqrt(plan_sd / plan_count), tip_floor);
      const auto take = [&](Extent& e, double value) {
        // A large change is a doubt, not a correction: the cloud's value stays, and the interval holds both.
        if (value < 0.93 * e.value || value > 1.25 * e.value) {
          e.sd = std::hypot(e.sd, 0.5 * (value - e.value));
          return;
        }
        e.value = value;
        e.sd = sd;
        extents.breadth_seen = true;
      };
      take(extents.length, rectangle.length);
      take(extents.width, rectangle.width);
    }
  }
  return seen;
}

}  // namespace bole::plant
