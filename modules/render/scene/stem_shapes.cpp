#include "render/scene/stem_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/angles.h"
#include "cloud/breast_height.h"
#include "cloud/stem_rows.h"
#include "render/charts/columns.h"

namespace bole::render {
namespace {

struct SectionRow {
  double height;
  Eigen::Vector3d centre;
  double radius;
};

std::map<std::int64_t, std::vector<SectionRow>> used_sections(const Table& sections) {
  std::map<std::int64_t, std::vector<SectionRow>> by_tree;
  const auto id = sections.integers("tree_id");
  const auto x = sections.numbers("x_m"), y = sections.numbers("y_m"), z = sections.numbers("z_m"),
             diameter = sections.numbers("diameter_cm"), height = sections.numbers("height_m");
  const auto used = numbers_or_nan(sections, sections.has("curve") ? "curve" : "used");
  for (std::size_t i = 0; i < id.size(); ++i)
    if (used[i] != 0 && std::isfinite(x[i] + y[i] + z[i] + diameter[i] + height[i]) && diameter[i] > 0)
      by_tree[id[i]].push_back({height[i], {x[i], y[i], z[i]}, diameter[i] / 200});
  for (auto& [tree, rows] : by_tree)
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
  return by_tree;
}

// From the ground to 0.6 m above the topmost section, along the straight line through the lowest and topmost section.
void shape_from_sections(const std::vector<SectionRow>& rows, StemShape& shape) {
  const auto& low = rows.front();
  const auto& high = rows.back();
  const double rise = std::max(high.height - low.height, 1e-6);
  const Eigen::Vector3d per_metre = (high.centre - low.centre) / rise;
  shape.axis.push_back(low.centre - low.height * per_metre);
  shape.radius_m.push_back(low.radius * 1.02);
  for (const auto& row : rows) shape.axis.push_back(row.centre), shape.radius_m.push_back(row.radius);
  shape.axis.push_back(high.centre + 0.6 * per_metre);
  shape.radius_m.push_back(high.radius);
}

}  // namespace

std::vector<StemShape> stem_shapes(const Table& stems, const Table* sections) {
  std::map<std::int64_t, std::vector<SectionRow>> by_tree;
  if (sections != nullptr && sections->has("tree_id")) by_tree = used_sections(*sections);
  const auto id = stems.integers("tree_id");
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), z = stems.numbers("z_m"),
             dbh = stems.numbers("dbh_cm");
  const auto lean = numbers_or_nan(stems, "lean_deg"), azimuth = numbers_or_nan(stems, "lean_azimuth_deg"),
             taper = numbers_or_nan(stems, "taper_cm_per_m"), height = known_heights(stems);
  const auto quality = texts_or_empty(stems, "quality");
  const double breast_height = breast_height_m(stems);
  std::vector<StemShape> shapes;
  for (std::size_t i = 0; i < id.size(); ++i) {
    if (!std::isfinite(x[i] + y[i] + z[i] + dbh[i])) continue;
    StemShape shape;
    shape.tree_id = id[i];
    shape.quality = quality[i];
    shape.breast_height = {x[i], y[i], z[i] + breast_height};
    shape.breast_radius_m = dbh[i] / 200;
    if (const auto it = by_tree.find(id[i]); it != by_tree.end() && it->second.size() >= 2) {
      shape_from_sections(it->second, shape);
    } else {
      const double tilt = std::isfinite(lean[i]) ? radians(lean[i]) : 0,
                   a = std::isfinite(azimuth[i]) ? radians(azimuth[i]) : 0;
      // Azimuths turn clockwise from north.
      const Eigen::Vector3d per_metre(std::tan(tilt) * std::sin(a), std::tan(tilt) * std::cos(a), 1);
      const double top = std::isfinite(height[i]) ? std::clamp(height[i], 2.0, 6.0) : 4.0;
      for (const double h : {0.0, breast_height, top}) {
        shape.axis.push_back(shape.breast_height + (h - breast_height) * per_metre);
        // Taper is what the diameter loses upwards.
        shape.radius_m.push_back(std::max(
            0.01, shape.breast_radius_m - (std::isfinite(taper[i]) ? taper[i] / 200 : 0) * (h - breast_height)));
      }
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

void drop_points_on_stems(const PointCloud& cloud, const std::vector<StemShape>& stems, double margin_m,
                          std::vector<std::uint32_t>& indices) {
  constexpr double cell_m = 0.5;
  const auto key = [](double x, double y) {
    return static_cast<std::int64_t>(std::floor(x / cell_m)) * 0x100000000LL +
           static_cast<std::int64_t>(std::floor(y / cell_m));
  };
  std::unordered_map<std::int64_t, std::vector<const StemShape*>> cells;
  for (const auto& stem : stems) {
    Eigen::Vector2d lo = stem.axis.front().head<2>(), hi = lo;
    for (std::size_t i = 0; i < stem.axis.size(); ++i) {
      const Eigen::Vector2d reach = Eigen::Vector2d::Constant(stem.radius_m[i] + margin_m);
      lo = lo.cwiseMin(stem.axis[i].head<2>() - reach);
      hi = hi.cwiseMax(stem.axis[i].head<2>() + reach);
    }
    for (double x = std::floor(lo.x() / cell_m); x <= std::floor(hi.x() / cell_m); ++x)
      for (double y = std::floor(lo.y() / cell_m); y <= std::floor(hi.y() / cell_m); ++y)
        cells[key((x + 0.5) * cell_m, (y + 0.5) * cell_m)].push_back(&stem);
  }
  const auto on_stem = [&](const Eigen::Vector3d& p) {
    const auto it = cells.find(key(p.x(), p.y()));
    if (it == cells.end()) return false;
    for (const auto* stem : it->second)
      for (std::size_t i = 0; i + 1 < stem->axis.size(); ++i) {
        const auto &a = stem->axis[i], &b = stem->axis[i + 1];
        if (p.z() < a.z() || p.z() > b.z()) continue;
        const double t = (p.z() - a.z()) / std::max(b.z() - a.z(), 1e-9);
        if ((p - a - t * (b - a)).head<2>().norm() <= std::lerp(stem->radius_m[i], stem->radius_m[i + 1], t) + margin_m)
          return true;
      }
    return false;
  };
  std::erase_if(indices, [&](std::uint32_t i) { return on_stem(cloud.position(i)); });
}

}  // namespace bole::render
