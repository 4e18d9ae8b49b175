#include "plant/core/leaves/leaf_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/angles.h"

namespace bole::plant {
namespace {

constexpr double lost_at_edge = 0.8;  // of the noise; fields of simulated plants lose 0.5 to 1 mm

double azimuth_of(const Leaf& leaf, const Eigen::Matrix3d& R_world_plant) {
  const Eigen::Vector3d d = R_world_plant * leaf.direction;
  return std::atan2(d.y(), d.x());
}

const char* quality_of(const Leaf& leaf) { return leaf.doubt.empty() ? "good" : "check"; }

}  // namespace

AreaBounds area_bounds(const Leaf& leaf, double scale_sd, double noise) {
  const auto& s = leaf.sheet;
  const double half = 1.96 * std::hypot(s.area_sd, 2 * scale_sd * s.area, 0.02 * s.area);
  // Parts of a leaf that touches another may have gone to it, or come from it.
  const double doubt = leaf.touching.empty() ? 0 : 0.15 * s.area;
  return {std::max(0.0, s.area - half - doubt), s.area + half + doubt + lost_at_edge * noise * s.edge};
}

Table leaf_table(const PlantOrgans& organs, const Eigen::Matrix3d& R_world_plant, double scale_sd, double noise) {
  std::vector<std::int64_t> number, axis;
  std::vector<double> height, x, y, z, azimuth, angle, length, width, petiole, area, low, high;
  std::vector<std::string> quality, remark;
  for (std::size_t i = 0; i < organs.leaves.size(); ++i) {
    const auto& leaf = organs.leaves[i];
    const auto bounds = area_bounds(leaf, scale_sd, noise);
    number.push_back(static_cast<std::int64_t>(i) + 1);
    axis.push_back(leaf.axis);
    height.push_back(1000 * leaf.node.z());
    x.push_back(leaf.node.x());
    y.push_back(leaf.node.y());
    z.push_back(leaf.node.z());
    azimuth.push_back(azimuth_of(leaf, R_world_plant) * deg_per_rad);
    angle.push_back(leaf.angle * deg_per_rad);
    length.push_back(1000 * leaf.sheet.length);
    width.push_back(1000 * leaf.sheet.width);
    petiole.push_back(1000 * leaf.petiole);
    area.push_back(1e4 * leaf.sheet.area);
    low.push_back(1e4 * bounds.low);
    high.push_back(1e4 * bounds.high);
    quality.emplace_back(quality_of(leaf));
    remark.push_back(leaf.doubt);
  }
  Table t;
  t.set("leaf", number);
  t.set("axis", axis);
  t.set("height_mm", height);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("z_m", z);
  t.set("azimuth_deg", azimuth);
  t.set("angle_deg", angle);
  t.set("length_mm", length);
  t.set("width_mm", width);
  t.set("petiole_mm", petiole);
  t.set("area_cm2", area);
  t.set("area_lo_cm2", low);
  t.set("area_hi_cm2", high);
  t.set("quality", quality);
  t.set("remark", remark);
  return t;
}

Table internode_table(const PlantOrgans& organs, const Eigen::Matrix3d& R_world_plant) {
  std::vector<std::int64_t> axis, from, to;
  std::vector<double> length, turn;
  std::vector<std::string> quality;
  for (std::size_t i = 1; i < organs.leaves.size(); ++i) {
    const auto &below = organs.leaves[i - 1], &above = organs.leaves[i];
    if (below.axis != above.axis) continue;
    axis.push_back(above.axis);
    from.push_back(static_cast<std::int64_t>(i));
    to.push_back(static_cast<std::int64_t>(i) + 1);
    length.push_back(1000 * (above.arc - below.arc));
    const double by = azimuth_of(above, R_world_plant) - azimuth_of(below, R_world_plant);
    turn.push_back(std::remainder(by, 2 * std::numbers::pi) * deg_per_rad);
    quality.emplace_back(below.doubt.empty() && above.doubt.empty() ? "good" : "check");
  }
  Table t;
  t.set("axis", axis);
  t.set("from_leaf", from);
  t.set("to_leaf", to);
  t.set("length_mm", length);
  t.set("turn_deg", turn);
  t.set("quality", quality);
  return t;
}

Table branch_table(const PlantOrgans& organs) {
  std::vector<std::int64_t> number, parent, leaves;
  std::vector<double> height, angle, length;
  for (std::size_t a = 1; a < organs.axes.size(); ++a) {
    const auto& axis = organs.axes[a];
    if (axis.curve.empty()) continue;
    number.push_back(static_cast<std::int64_t>(a));
    parent.push_back(axis.parent);
    height.push_back(1000 * axis.curve.places.front().z());
    angle.push_back(axis.angle * deg_per_rad);
    length.push_back(1000 * axis.curve.length());
    leaves.push_back(std::ranges::count(organs.leaves, static_cast<int>(a), &Leaf::axis));
  }
  Table t;
  t.set("branch", number);
  t.set("parent", parent);
  t.set("height_mm", height);
  t.set("angle_deg", angle);
  t.set("length_mm", length);
  t.set("leaves", leaves);
  return t;
}

}  // namespace bole::plant
