#include "sim/core/seedling/plant_truth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "sim/core/seedling/plant_mesh.h"

namespace bole::sim {
namespace {

double turn_of(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d u = a - o, v = b - o;
  return u.x() * v.y() - u.y() * v.x();
}

// Monotone chain (Andrew 1979), counterclockwise.
std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> points) {
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  std::vector<Eigen::Vector2d> hull;
  for (const bool upper : {false, true}) {
    const std::size_t start = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= start + 2 && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    if (!upper) std::ranges::reverse(points);
  }
  return hull;
}

// Arc length of the stem at a height above the soil.
double arc_at_height(const PlantForm& plant, double height) {
  const auto& stem = plant.axes.front();
  const double z = plant.foot.z() + height;
  for (std::size_t i = 1; i < stem.points.size(); ++i) {
    const double low = stem.points[i - 1].z(), high = stem.points[i].z();
    if (high >= z)
      return stem.arc[i - 1] + (stem.arc[i] - stem.arc[i - 1]) * std::clamp((z - low) / (high - low), 0.0, 1.0);
  }
  return stem.length();
}

template <class T>
void put(std::ofstream& out, const T& value) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), static_cast<const void*>(&value),
              sizeof(T));  // little-endian, as the processors that Bole runs on
  out.write(bytes.data(), sizeof(T));
}

}  // namespace

Eigen::Vector2d smallest_rectangle(std::vector<Eigen::Vector2d> points) {
  const auto hull = hull_of(std::move(points));
  Eigen::Vector2d best(0, 0);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d u = (hull[(i + 1) % hull.size()] - hull[i]).normalized(), v(-u.y(), u.x());
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
    for (const auto& p : hull) {
      const Eigen::Vector2d q(u.dot(p), v.dot(p));
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
    const Eigen::Vector2d size = high - low;
    if (size.prod() >= least) continue;
    least = size.prod();
    best = {size.maxCoeff(), size.minCoeff()};
  }
  return best;
}

Table plant_traits(const PlantForm& plant, const std::vector<ScenePart>& parts, const std::string& plant_id,
                   double stem_height) {
  std::vector<Eigen::Vector2d> plan;
  double top = 0;
  for (const auto& part : parts) {
    if (part.label != PartLabel::plant) continue;
    for (const auto& p : part.positions) {
      const Eigen::Vector3d above = p.cast<double>() - plant.foot;
      if (above.z() < 0) continue;  // in the soil
      plan.emplace_back(above.x(), above.y());
      top = std::max(top, above.z());
    }
  }
  const auto breadth = smallest_rectangle(std::move(plan));
  const auto& stem = plant.axes.front();
  double area = 0, wings = 0, volume = 0;
  for (const auto& leaf : plant.leaves) {
    area += blade_area(leaf);
    wings += wing_area(leaf);
  }
  const double soil_arc = arc_at_height(plant, 0);
  for (std::size_t i = 1; i < stem.arc.size(); ++i) {
    const double length = stem.arc[i] - std::max(soil_arc, stem.arc[i - 1]);
    if (length > 0) volume += std::numbers::pi * length * stem.radii[i] * stem.radii[i - 1];
  }
  Table t;
  const auto set = [&](const char* name, double value) { t.set(name, std::vector<double>{value}); };
  t.set("plant_id", std::vector<std::string>{plant_id});
  set("height_mm", 1000 * top);
  set("breadth_length_mm", 1000 * breadth.x());
  set("breadth_width_mm", 1000 * breadth.y());
  set("stem_diameter_mm", 2000 * stem.radius_at(arc_at_height(plant, stem_height)));
  t.set("leaf_count", std::vector<std::int64_t>{static_cast<std::int64_t>(plant.leaves.size())});
  set("leaf_area_cm2", 1e4 * area);
  set("wing_area_cm2", 1e4 * wings);
  t.set("branch_count", std::vector<std::int64_t>{static_cast<std::int64_t>(plant.axes.size()) - 1});
  set("stem_length_mm", 1000 * (stem.length() - soil_arc));
  set("stem_volume_cm3", 1e6 * volume);
  return t;
}

Table leaf_table(const PlantForm& plant) {
  std::vector<std::int64_t> number, axis;
  std::vector<double> height, azimuth, angle, length, width, petiole, area;
  for (std::size_t i = 0; i < plant.leaves.size(); ++i) {
    const auto& leaf = plant.leaves[i];
    const auto& of = plant.axes[static_cast<std::size_t>(leaf.axis)];
    const Eigen::Vector3d along = leaf.frame.col(0);
    number.push_back(static_cast<std::int64_t>(i));
    axis.push_back(leaf.axis);
    height.push_back(1000 * (leaf.base.z() - plant.foot.z()));
    azimuth.push_back(std::atan2(along.y(), along.x()) * deg_per_rad);
    angle.push_back(std::acos(std::clamp(along.dot(of.tangent_at(leaf.axis_arc)), -1.0, 1.0)) * deg_per_rad);
    length.push_back(1000 * leaf.length);
    width.push_back(1000 * leaf.width);
    petiole.push_back(1000 * leaf.petiole);
    area.push_back(1e4 * blade_area(leaf));
  }
  Table t;
  t.set("leaf", number);
  t.set("axis", axis);
  t.set("height_mm", height);
  t.set("azimuth_deg", azimuth);
  t.set("angle_deg", angle);
  t.set("length_mm", length);
  t.set("width_mm", width);
  t.set("petiole_mm", petiole);
  t.set("area_cm2", area);
  return t;
}

Table internode_table(const PlantForm& plant) {
  std::vector<std::int64_t> axis, from, to;
  std::vector<double> length;
  for (std::size_t i = 1; i < plant.leaves.size(); ++i) {
    if (plant.leaves[i].axis != plant.leaves[i - 1].axis) continue;
    axis.push_back(plant.leaves[i].axis);
    from.push_back(static_cast<std::int64_t>(i) - 1);
    to.push_back(static_cast<std::int64_t>(i));
    length.push_back(1000 * (plant.leaves[i].axis_arc - plant.leaves[i - 1].axis_arc));
  }
  Table t;
  t.set("axis", axis);
  t.set("from_leaf", from);
  t.set("to_leaf", to);
  t.set("length_mm", length);
  return t;
}

Table stem_table(const PlantForm& plant) {
  const auto& stem = plant.axes.front();
  const double soil_arc = arc_at_height(plant, 0);
  std::vector<double> arc, x, y, z, diameter;
  for (std::size_t i = 0; i < stem.points.size(); ++i) {
    if (stem.arc[i] < soil_arc) continue;
    arc.push_back(1000 * (stem.arc[i] - soil_arc));
    x.push_back(stem.points[i].x());
    y.push_back(stem.points[i].y());
    z.push_back(stem.points[i].z());
    diameter.push_back(2000 * stem.radii[i]);
  }
  Table t;
  t.set("arc_mm", arc);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("z_m", z);
  t.set("diameter_mm", diameter);
  return t;
}

Table branch_table(const PlantForm& plant) {
  std::vector<std::int64_t> number;
  std::vector<double> height, angle, length, diameter;
  for (std::size_t i = 1; i < plant.axes.size(); ++i) {
    const auto& branch = plant.axes[i];
    const auto& stem = plant.axes[static_cast<std::size_t>(branch.parent)];
    number.push_back(static_cast<std::int64_t>(i));
    height.push_back(1000 * (branch.points.front().z() - plant.foot.z()));
    const double cosine = branch.tangent_at(0).dot(stem.tangent_at(branch.parent_arc));
    angle.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * deg_per_rad);
    length.push_back(1000 * branch.length());
    diameter.push_back(2000 * branch.radii.front());
  }
  Table t;
  t.set("branch", number);
  t.set("height_mm", height);
  t.set("angle_deg", angle);
  t.set("length_mm", length);
  t.set("diameter_mm", diameter);
  return t;
}

void write_mesh(const std::filesystem::path& file, const std::vector<ScenePart>& parts) {
  std::size_t vertices = 0, faces = 0;
  for (const auto& part : parts) {
    if (part.label == PartLabel::other) continue;
    vertices += part.positions.size();
    faces += part.triangles.size();
  }
  std::ofstream out(file, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\ncomment part: 1 plant, 2 pot, 3 soil, 4 mat; metres\nelement vertex "
      << vertices << "\nproperty float x\nproperty float y\nproperty float z\nproperty int part\nelement face " << faces
      << "\nproperty list uchar int vertex_indices\nproperty int part\nproperty int leaf\nend_header\n";
  for (const auto& part : parts) {
    if (part.label == PartLabel::other) continue;
    for (const auto& p : part.positions) {
      put(out, p);
      put(out, static_cast<std::int32_t>(part.label));
    }
  }
  std::int32_t first = 0;
  for (const auto& part : parts) {
    if (part.label == PartLabel::other) continue;
    for (const auto& triangle : part.triangles) {
      put(out, std::uint8_t{3});
      for (const auto v : triangle) put(out, first + static_cast<std::int32_t>(v));
      put(out, static_cast<std::int32_t>(part.label));
      put(out, part.leaf);
    }
    first += static_cast<std::int32_t>(part.positions.size());
  }
  out.close();
  if (!out) throw failure("cannot write " + file.string());
}

}  // namespace bole::sim
