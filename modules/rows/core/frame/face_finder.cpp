#include "rows/core/frame/face_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "rows/core/frame/trunk_face.h"

namespace bole::rows {
namespace {

constexpr double hidden_share = 0.65;  // of the usual radius: thinner strips may be hidden in part

}  // namespace

FaceFinder::FaceFinder(const PointCloud& dense, const TrunkOptions& options)
    : dense_(dense), o_(options), widest_(std::max(options.max_extent_x, options.max_extent_y)) {}

std::optional<FoundTrunk> FaceFinder::find(std::int32_t plant, const Eigen::Vector2d& middle, double foot,
                                           double top) const {
  const auto strip =
      find_upright(about(middle, o_.reach + widest_ / 2, foot, top), widest_, o_.range_sigma, o_.layer_height / 2);
  if (strip.high_m - strip.low_m < o_.min_height || strip.filled < o_.min_filled) return {};
  auto near = about(strip.at, widest_ / 2 + 4 * o_.range_sigma, strip.low_m, strip.high_m);
  const auto fit = fit_trunk_face(near, strip.at, widest_, o_.range_sigma);
  // Too few points may remain visible behind a nearer trunk.
  if (!fit) return FoundTrunk{strip.at, 0, plant, strip.layers, std::ssize(near), std::move(near)};
  FoundTrunk trunk{fit->centre, 200 * fit->radius_m, plant, strip.layers, fit->points};
  // Of what is near: without the leaves around it and the ground at its foot.
  const double reach = fit->radius_m + 2 * o_.range_sigma;
  for (const auto& p : near)
    if (p.z() > strip.low_m + o_.layer_height && (p.head<2>() - fit->centre).norm() < reach) trunk.shown.push_back(p);
  return trunk;
}

void FaceFinder::uncover(std::vector<FoundTrunk>& trunks) {
  if (trunks.size() < 3) return;
  std::vector<double> radii;
  for (const auto& t : trunks) radii.push_back(t.diameter_cm / 200);
  const double usual = upper_median(radii);
  const auto seen = trunks;
  for (auto& t : trunks) {
    const double r = t.diameter_cm / 200, range = t.centre.norm(), bearing = std::atan2(t.centre.x(), t.centre.y());
    if (r > hidden_share * usual) continue;
    for (const auto& near : seen) {
      const double near_range = near.centre.norm(), near_half = near.diameter_cm / 200 / near_range;
      if (near_range > range - 2 * usual) continue;
      const double apart = std::remainder(bearing - std::atan2(near.centre.x(), near.centre.y()), 2 * std::numbers::pi);
      if (std::abs(std::abs(apart) - near_half - r / range) > 0.3 * usual / range) continue;
      // The hidden part lies towards the nearer trunk.
      const Eigen::Vector2d ahead = t.centre / range, right(ahead.y(), -ahead.x());
      const double aside = usual - r, face = range - std::numbers::pi / 4 * r;
      t.centre = (face + std::sqrt(usual * usual - aside * aside)) * ahead - std::copysign(aside, apart) * right;
      t.diameter_cm = 200 * usual;
      break;
    }
  }
}

std::vector<FoundTrunk> FaceFinder::distinct(std::vector<FoundTrunk> trunks) const {
  std::stable_sort(trunks.begin(), trunks.end(), [](const auto& a, const auto& b) {
    return std::pair(a.layers, a.points) > std::pair(b.layers, b.points);
  });
  std::vector<FoundTrunk> kept;
  for (const auto& t : trunks)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const auto& k) { return (k.centre - t.centre).norm() < 1.2 * widest_; }))
      kept.push_back(t);
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.plant < b.plant; });
  return kept;
}

std::vector<Eigen::Vector3d> FaceFinder::about(const Eigen::Vector2d& at, double reach_m, double low_m,
                                               double high_m) const {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector3f centre =
      Eigen::Vector3d(at.x() - dense_.origin.x(), at.y() - dense_.origin.y(), 0).cast<float>();
  const auto reach = static_cast<float>(reach_m);
  for (std::size_t i = 0; i < dense_.size(); ++i) {
    const auto& q = dense_.positions()[i];
    if (std::abs(q.x() - centre.x()) > reach || std::abs(q.y() - centre.y()) > reach) continue;
    const Eigen::Vector3d p = dense_.position(i);
    if (p.z() > low_m && p.z() < high_m && (p.head<2>() - at).norm() < reach_m) points.push_back(p);
  }
  return points;
}

}  // namespace bole::rows
