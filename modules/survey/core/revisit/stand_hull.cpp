#include "survey/core/revisit/stand_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::survey {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Half of Andrew's monotone chain.
void add_chain(const std::vector<Eigen::Vector2d>& sorted, std::vector<Eigen::Vector2d>& hull) {
  const auto begin = hull.size();
  for (const auto& p : sorted) {
    while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(p);
  }
  hull.pop_back();
}

}  // namespace

StandHull::StandHull(std::vector<Eigen::Vector2d> places) {
  std::ranges::sort(places,
                    [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (places.size() < 3) {
    corners_ = std::move(places);
    return;
  }
  add_chain(places, corners_);
  std::ranges::reverse(places);
  add_chain(places, corners_);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    area_m2_ += cross(corners_[i], corners_[(i + 1) % corners_.size()]) / 2;
}

bool StandHull::contains(const Eigen::Vector2d& p, double margin_m) const {
  if (corners_.empty()) return false;
  // The signed distance to the outline, positive inside.
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = corners_.size() >= 3;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d& a = corners_[i];
    const Eigen::Vector2d along = corners_[(i + 1) % corners_.size()] - a;
    if (cross(along, p - a) < 0) inside = false;
    const double t = std::clamp((p - a).dot(along) / std::max(1e-12, along.squaredNorm()), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * along).norm());
  }
  return (inside ? nearest : -nearest) >= -margin_m - 1e-9;
}

}  // namespace bole::survey
