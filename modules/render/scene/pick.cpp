#include "render/scene/pick.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::render {
namespace {

constexpr double same_depth = 0.02;  // of the distance: points this close in depth lie on one surface

// Distance of p from the stretch a-b, and where on it the nearest place is.
std::pair<double, double> from_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
  return {(p - a - t * ab).norm(), t};
}

}  // namespace

std::optional<OnScreen> on_screen(const PickView& view, const Eigen::Vector3d& world) {
  const Eigen::Vector4d clip = view.world_to_clip * (world - view.origin).homogeneous();
  if (!(clip.w() > 1e-9)) return {};
  return OnScreen{{(clip.x() / clip.w() + 1) / 2 * view.width_px, (clip.y() / clip.w() + 1) / 2 * view.height_px},
                  clip.z() / clip.w()};
}

// A box before the eye is seen within the rectangle about its corners.
bool may_be_near(const PickView& view, const Eigen::AlignedBox3d& box, const Eigen::Vector2d& at_px, double reach_px) {
  Eigen::AlignedBox2d seen;
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = on_screen(view, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    if (!at) return true;
    seen.extend(at->px);
  }
  return seen.exteriorDistance(at_px) <= reach_px;
}

AboutPixel::AboutPixel(const PickView& view, const Eigen::Vector3d& origin, const Eigen::Vector2d& at_px) {
  Eigen::Matrix4d translate = Eigen::Matrix4d::Identity();
  translate.topRightCorner<3, 1>() = origin - view.origin;
  const Eigen::Matrix4d m = view.world_to_clip * translate;
  right_ = view.width_px / 2 * m.row(0) + (view.width_px / 2 - at_px.x()) * m.row(3);
  up_ = view.height_px / 2 * m.row(1) + (view.height_px / 2 - at_px.y()) * m.row(3);
  depth_ = m.row(2), away_ = m.row(3);
}

std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segment_on_screen(const PickView& view,
                                                                             const Eigen::Vector3d& a,
                                                                             const Eigen::Vector3d& b) {
  constexpr double min_w = 1e-3;  // a parallel view has 1 everywhere
  Eigen::Vector4d ends[2] = {view.world_to_clip * (a - view.origin).homogeneous(),
                             view.world_to_clip * (b - view.origin).homogeneous()};
  if (ends[0].w() < min_w && ends[1].w() < min_w) return {};
  for (auto& end : ends)
    if (end.w() < min_w) {
      const Eigen::Vector4d& other = &end == &ends[0] ? ends[1] : ends[0];
      end = other + (other.w() - min_w) / (other.w() - end.w()) * (end - other);
    }
  const auto px = [&](const Eigen::Vector4d& clip) {
    return Eigen::Vector2d((clip.x() / clip.w() + 1) / 2 * view.width_px,
                           (clip.y() / clip.w() + 1) / 2 * view.height_px);
  };
  return std::pair{px(ends[0]), px(ends[1])};
}

Eigen::Vector3d at_depth(const PickView& view, const Eigen::Vector2d& at_px, double depth) {
  const Eigen::Vector4d p =
      view.world_to_clip.inverse() *
      Eigen::Vector4d(2 * at_px.x() / view.width_px - 1, 2 * at_px.y() / view.height_px - 1, depth, 1);
  return p.head<3>() / p.w() + view.origin;
}

std::optional<Eigen::Vector3d> on_line(const PickView& view, const Eigen::Vector2d& at_px, const Eigen::Vector3d& at,
                                       const Eigen::Vector3d& direction) {
  constexpr double min_sine = 0.02;
  const Eigen::Vector3d near = at_depth(view, at_px, -1), ray = (at_depth(view, at_px, 1) - near).normalized();
  const double cosine = ray.dot(direction), sine_squared = 1 - cosine * cosine;
  if (!(sine_squared > min_sine * min_sine)) return {};
  const Eigen::Vector3d between = near - at;
  const double along = (between.dot(direction) - cosine * between.dot(ray)) / sine_squared;
  if (!std::isfinite(along)) return {};
  return at + along * direction;
}

std::optional<Eigen::Vector3d> on_plane(const PickView& view, const Eigen::Vector2d& at_px, double z) {
  const Eigen::Vector3d near = at_depth(view, at_px, -1), along = at_depth(view, at_px, 1) - near;
  const double t = (z - near.z()) / along.z();
  if (!std::isfinite(t) || t < 0) return {};
  return near + t * along;
}

namespace {

struct NearPoint {
  std::size_t set;
  std::uint32_t index;
  double px, w;
};

void add_near(const PickView& view, const PointCloud& cloud, std::span<const std::uint32_t> indices,
              const Eigen::Vector2d& at_px, double reach_px, std::size_t set, std::vector<NearPoint>& near) {
  const AboutPixel about(view, cloud.origin, at_px);
  const auto& positions = cloud.positions();
  for (const auto i : indices) {
    const Eigen::Vector3d p = positions[i].cast<double>();
    const auto place = about(p);
    if (!place.within(reach_px)) continue;
    const double z = about.depth(p);
    // In a parallel view w is one everywhere; z orders the points there.
    if (std::abs(z) <= place.w)
      near.push_back({set, i, std::hypot(place.right_px, place.up_px) / place.w, place.w + z});
  }
}

// The least that NearPoint::w can be of points in a box: it is linear in the place, so a corner has it.
double nearest_of(const PickView& view, const Eigen::AlignedBox3d& box) {
  double nearest = std::numeric_limits<double>::infinity();
  if (box.isEmpty()) return -nearest;
  const Eigen::RowVector4d w = view.world_to_clip.row(2) + view.world_to_clip.row(3);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d at = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - view.origin;
    nearest = std::min<double>(nearest, w * at.homogeneous());
  }
  return nearest;
}

double reach_of_surface(double front) { return front + same_depth * std::abs(front); }

const NearPoint* best_of(const std::vector<NearPoint>& near) {
  if (near.empty()) return nullptr;
  const auto front = std::ranges::min_element(near, {}, &NearPoint::w);
  auto best = front;
  for (auto n = near.begin(); n != near.end(); ++n)
    if (n->w <= reach_of_surface(front->w) && n->px < best->px) best = n;
  return &*best;
}

}  // namespace

std::optional<std::uint32_t> pick_point(const PickView& view, const PointCloud& cloud,
                                        std::span<const std::uint32_t> indices, const Eigen::Vector2d& at_px,
                                        double reach_px) {
  std::vector<NearPoint> near;
  add_near(view, cloud, indices, at_px, reach_px, 0, near);
  const auto* best = best_of(near);
  return best == nullptr ? std::nullopt : std::optional(best->index);
}

std::optional<PickedPoint> pick_point(const PickView& view, const std::vector<PointSet>& drawn,
                                      const Eigen::Vector2d& at_px, double reach_px) {
  // The foremost sets first: most of the others lie behind a point that was found.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < drawn.size(); ++k) order.emplace_back(nearest_of(view, drawn[k].box), k);
  std::ranges::sort(order);
  std::vector<NearPoint> near;
  double front = std::numeric_limits<double>::infinity();
  for (const auto& [nearest, k] : order) {
    if (nearest > reach_of_surface(front)) break;
    const std::size_t before = near.size();
    add_near(view, *drawn[k].cloud, drawn[k].indices, at_px, reach_px, k, near);
    for (std::size_t i = before; i < near.size(); ++i) front = std::min(front, near[i].w);
  }
  const auto* best = best_of(near);
  return best == nullptr ? std::nullopt : std::optional(PickedPoint{drawn[best->set].cloud, best->index});
}

std::optional<PickedStem> pick_stem(const PickView& view, const std::vector<StemShape>& stems,
                                    const Eigen::Vector2d& at_px, double reach_px) {
  std::optional<PickedStem> best;
  for (const auto& stem : stems) {
    for (std::size_t k = 0; k + 1 < stem.axis.size(); ++k) {
      const auto a = on_screen(view, stem.axis[k]), b = on_screen(view, stem.axis[k + 1]);
      if (!a || !b) continue;
      const auto [distance, t] = from_segment(at_px, a->px, b->px);
      // The radius on the screen is that of a ring around the axis there, seen from the side.
      const Eigen::Vector3d centre = stem.axis[k] + t * (stem.axis[k + 1] - stem.axis[k]);
      double radius_px = 0;
      for (const Eigen::Vector3d& side :
           {Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(Eigen::Vector3d::UnitY())})
        if (const auto rim = on_screen(view, centre + std::lerp(stem.radius_m[k], stem.radius_m[k + 1], t) * side))
          radius_px = std::max(radius_px, (rim->px - (a->px + t * (b->px - a->px))).norm());
      const double depth = std::lerp(a->depth, b->depth, t);
      if (distance <= radius_px + reach_px && (!best || depth < best->depth)) best = PickedStem{stem.tree_id, depth};
    }
  }
  return best;
}

std::vector<std::string> describe_point(const PointCloud& cloud, std::uint32_t index) {
  const Eigen::Vector3d p = exact_position(cloud, index);
  std::vector<std::string> lines{fmt::format("x {:.3f}  y {:.3f}  z {:.3f} m", p.x(), p.y(), p.z())};
  const auto say = [&](std::string_view array, std::string_view name, std::string_view unit, int decimals) {
    if (!cloud.has(array)) return;
    const double value = column_value(cloud.column(array), index);
    lines.push_back(std::isfinite(value)
                        ? fmt::format("{} {:.{}f}{}{}", name, value, decimals, unit.empty() ? "" : " ", unit)
                        : fmt::format("{} not known", name));
  };
  say("height_above_ground", "above ground", "m", 2);
  say("range", "range", "m", 2);
  say("time", "time", "s", 3);
  say("intensity", "intensity", "", 0);
  say("pass", "pass", "", 0);
  if (cloud.has(arrays::tree_id) && column_value(cloud.column("tree_id"), index) > 0) say("tree_id", "tree", "", 0);
  return lines;
}

}  // namespace bole::render
