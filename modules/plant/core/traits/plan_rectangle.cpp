#include "plant/core/traits/plan_rectangle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "base/random.h"

namespace bole::plant {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = std::vector<Kernel::Point_2>;

Hull hull_of(const std::vector<Eigen::Vector2d>& points) {
  Hull plan, hull;
  plan.reserve(points.size());
  for (const auto& p : points) plan.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(plan.begin(), plan.end(), std::back_inserter(hull));
  return hull;
}

}  // namespace

PlanRectangle smallest_rectangle(const std::vector<Eigen::Vector2d>& points) {
  const auto hull = hull_of(points);
  PlanRectangle out;
  if (hull.size() < 3) return out;
  CGAL::Polygon_2<Kernel> rectangle;
  CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(rectangle));
  if (rectangle.size() != 4) return out;
  for (std::size_t k = 0; k < 4; ++k) out.corners[k] = {rectangle[k].x(), rectangle[k].y()};
  const double a = (out.corners[1] - out.corners[0]).norm(), b = (out.corners[2] - out.corners[1]).norm();
  out.length = std::max(a, b);
  out.width = std::min(a, b);
  return out;
}

RectangleScatter rectangle_scatter(const std::vector<Eigen::Vector2d>& points, double side_sd, double patch) {
  constexpr int replicates = 96;
  const auto best = smallest_rectangle(points);
  if (!(best.length > 0) || !(side_sd > 0)) return {};
  const Eigen::Vector2d middle = (best.corners[0] + best.corners[2]) / 2;
  // Of each patch its outermost point in every direction of its hull; what lies well inside never counts.
  std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>> patches;
  for (const auto& p : points) {
    const Eigen::Vector2d at = (p - middle) / patch;
    patches[{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))}].push_back(p);
  }
  std::vector<std::vector<Eigen::Vector2d>> outlines;
  for (const auto& [place, members] : patches) {
    std::vector<Eigen::Vector2d> outline;
    for (const auto& p : hull_of(members)) outline.emplace_back(p.x(), p.y());
    outlines.push_back(std::move(outline));
  }
  double length = 0, width = 0;
  for (int r = 0; r < replicates; ++r) {
    Random random(53, 0, static_cast<std::uint64_t>(r));
    std::vector<Eigen::Vector2d> moved;
    for (const auto& outline : outlines) {
      const double out = side_sd * random.normal();
      for (const auto& p : outline) moved.push_back(p + out * (p - middle).normalized());
    }
    const auto now = smallest_rectangle(moved);
    length += (now.length - best.length) * (now.length - best.length) / replicates;
    width += (now.width - best.width) * (now.width - best.width) / replicates;
  }
  return {std::sqrt(length), std::sqrt(width)};
}

}  // namespace bole::plant
