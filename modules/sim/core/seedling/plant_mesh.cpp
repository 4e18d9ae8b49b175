#include "sim/core/seedling/plant_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

// A polygon with the area of the circle.
double corner_radius(double radius, int sides) {
  const double a = two_pi / sides;
  return radius * std::sqrt(a / std::sin(a));
}

// The seam has two columns of vertices, so that `uv` has no jump. The tip is a dome of one ring and a point.
ScenePart tube(const std::vector<Eigen::Vector3d>& path, const std::vector<double>& arc,
               const std::vector<double>& radii, int sides) {
  ScenePart part;
  part.surface = PartSurface::wood;
  part.label = PartLabel::plant;
  Eigen::Vector3d side = Eigen::Vector3d::UnitX();
  const auto columns = static_cast<std::uint32_t>(sides + 1);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d along = (path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]).normalized();
    if (std::abs(side.dot(along)) > 0.95) side = Eigen::Vector3d::UnitY();
    side = (side - side.dot(along) * along).normalized();  // carried along without twist
    const Eigen::Vector3d third = along.cross(side);
    const double r = corner_radius(radii[i], sides);
    for (int k = 0; k <= sides; ++k) {
      const double a = two_pi * k / sides;
      part.add(path[i] + r * (std::cos(a) * side + std::sin(a) * third), {arc[i], a * radii[i]});
    }
    if (i == 0) continue;
    const auto row = static_cast<std::uint32_t>(i) * columns;
    for (std::uint32_t k = 0; k + 1 < columns; ++k) {
      part.triangles.push_back({row - columns + k, row - columns + k + 1, row + k + 1});
      part.triangles.push_back({row - columns + k, row + k + 1, row + k});
    }
  }
  const auto last = static_cast<std::uint32_t>(part.positions.size()) - columns;
  const auto tip = part.add(path.back(), {arc.back(), 0});
  for (std::uint32_t k = 0; k + 1 < columns; ++k) part.triangles.push_back({last + k, last + k + 1, tip});
  part.set_normals();
  for (std::size_t i = 0; i < path.size(); ++i) {  // the seam is one line
    auto& a = part.normals[i * columns];
    auto& b = part.normals[i * columns + columns - 1];
    a = b = (a + b).normalized();
  }
  return part;
}

using SheetPoint = Eigen::Vector3d (*)(const PlantLeaf&, double, double);

struct SheetGrid {
  int rows = 0, columns = 0;  // along, across
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<Eigen::Vector2d> at;
  std::size_t index(int r, int c) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
  }
};

SheetGrid sheet_grid(const PlantLeaf& leaf, SheetPoint point, double length) {
  SheetGrid grid;
  grid.rows = std::clamp(static_cast<int>(length / 0.0022), 6, 40) + 1;
  grid.columns = 11;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const double along = 0.004 + 0.992 * r / (grid.rows - 1), across = 2.0 * c / (grid.columns - 1) - 1;
      grid.at.emplace_back(along, across);
      grid.points.push_back(point(leaf, along, across));
      const double d = 1e-3;
      const Eigen::Vector3d ahead = point(leaf, std::min(1.0, along + d), across) - point(leaf, along - d, across);
      const Eigen::Vector3d side = point(leaf, along, across + d) - point(leaf, along, across - d);
      const Eigen::Vector3d n = ahead.cross(side);
      grid.normals.push_back(n.norm() > 1e-15 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d(leaf.frame.col(2)));
    }
  return grid;
}

double sheet_area(const SheetGrid& g) {
  double area = 0;
  for (int r = 0; r + 1 < g.rows; ++r)
    for (int c = 0; c + 1 < g.columns; ++c) {
      const auto &a = g.points[g.index(r, c)], &b = g.points[g.index(r + 1, c)], &d = g.points[g.index(r, c + 1)];
      const auto& e = g.points[g.index(r + 1, c + 1)];
      area += 0.5 * ((b - a).cross(e - a).norm() + (e - a).cross(d - a).norm());
    }
  return area;
}

// Upper side and underside; the thickness falls to half at the margin, which is closed by the underside.
void add_sheet(std::vector<ScenePart>& parts, const PlantLeaf& leaf, int number, SheetPoint point, double length) {
  const SheetGrid g = sheet_grid(leaf, point, length);
  for (const bool under : {false, true}) {
    ScenePart part;
    part.surface = PartSurface::leaf;
    part.label = PartLabel::plant;
    part.under = under;
    part.leaf = number;
    part.pivot = leaf.base.cast<float>();
    part.tone = {static_cast<float>(leaf.yellow), static_cast<float>(leaf.hue), static_cast<float>(leaf.brightness),
                 static_cast<float>(leaf.phase)};
    for (std::size_t i = 0; i < g.points.size(); ++i) {
      const double edge = std::pow(g.at[i].y(), 4);
      part.add(g.points[i] + (under ? -0.5 : 0.5) * leaf.thickness * (1 - 0.5 * edge) * g.normals[i], g.at[i]);
    }
    for (int r = 0; r + 1 < g.rows; ++r)
      for (int c = 0; c + 1 < g.columns; ++c) {
        const auto a = static_cast<std::uint32_t>(g.index(r, c)), b = static_cast<std::uint32_t>(g.index(r + 1, c));
        std::array<std::uint32_t, 3> one{a, b, b + 1}, two{a, b + 1, a + 1};
        if (under) {
          std::swap(one[1], one[2]);
          std::swap(two[1], two[2]);
        }
        part.triangles.push_back(one);
        part.triangles.push_back(two);
      }
    part.set_normals();
    if (under) {
      // The rim is wound from the points of the upper side, which are repeated here.
      const auto offset = static_cast<std::uint32_t>(part.positions.size());
      const auto upper = parts.back();
      std::vector<std::uint32_t> rim;
      const auto add = [&](int r, int c) { rim.push_back(static_cast<std::uint32_t>(g.index(r, c))); };
      for (int r = 0; r < g.rows; ++r) add(r, 0);
      for (int c = 1; c < g.columns; ++c) add(g.rows - 1, c);
      for (int r = g.rows - 2; r >= 0; --r) add(r, g.columns - 1);
      for (int c = g.columns - 2; c >= 0; --c) add(0, c);
      for (const auto v : rim) {
        part.positions.push_back(upper.positions[v]);
        part.normals.push_back((upper.positions[v] - leaf.base.cast<float>()).normalized());
        part.uv.push_back(upper.uv[v]);
      }
      for (std::uint32_t k = 0; k + 1 < rim.size(); ++k) {
        part.triangles.push_back({rim[k], rim[k + 1], offset + k});
        part.triangles.push_back({rim[k + 1], offset + k + 1, offset + k});
      }
    }
    parts.push_back(std::move(part));
  }
}

void add_petiole(std::vector<ScenePart>& parts, const PlantLeaf& leaf, int number) {
  std::vector<Eigen::Vector3d> path;
  std::vector<double> arc, radii;
  // The petiole goes on as the midrib, ever thinner, to a third of the blade.
  for (int i = 0; i <= 12; ++i) {
    const double s = i / 12.0 * (leaf.petiole + 0.35 * leaf.length);
    const bool in_blade = s > leaf.petiole;
    Eigen::Vector3d at = leaf.base + s * leaf.frame.col(0);
    if (in_blade) at = blade_point(leaf, (s - leaf.petiole) / leaf.length, 0);
    const double share = in_blade ? 1 - 0.9 * (s - leaf.petiole) / (0.35 * leaf.length) : 1;
    radii.push_back(leaf.petiole_radius * share);
    path.push_back(at - 0.5 * (1 - share) * leaf.petiole_radius * leaf.frame.col(2));
    arc.push_back(s);
  }
  auto part = tube(path, arc, radii, 10);
  part.leaf = number;
  part.pivot = leaf.base.cast<float>();
  part.tone = {1, static_cast<float>(leaf.hue), static_cast<float>(leaf.brightness), 0};
  parts.push_back(std::move(part));
}

}  // namespace

double blade_area(const PlantLeaf& leaf) { return sheet_area(sheet_grid(leaf, blade_point, leaf.length)); }

double wing_area(const PlantLeaf& leaf) {
  return leaf.wing > 0 ? sheet_area(sheet_grid(leaf, wing_point, leaf.petiole)) : 0;
}

std::vector<ScenePart> plant_parts(const PlantForm& plant) {
  std::vector<ScenePart> parts;
  for (std::size_t a = 0; a < plant.axes.size(); ++a) {
    const auto& axis = plant.axes[a];
    parts.push_back(tube(axis.points, axis.arc, axis.radii, a == 0 ? 48 : 32));
    parts.back().tone = {a == 0 ? 0.0F : 0.6F, 0, 1, static_cast<float>(a)};
  }
  for (std::size_t i = 0; i < plant.leaves.size(); ++i) {
    const auto& leaf = plant.leaves[i];
    const auto number = static_cast<int>(i);
    add_petiole(parts, leaf, number);
    if (leaf.wing > 0) add_sheet(parts, leaf, number, wing_point, leaf.petiole);
    add_sheet(parts, leaf, number, blade_point, leaf.length);
  }
  return parts;
}

}  // namespace bole::sim
