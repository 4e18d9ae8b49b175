#include "plant/core/traits/trait_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angles.h"
#include "base/no_number.h"

namespace bole::plant {
namespace {

void set_interval(Table& table, const std::string& name, const Interval& v) {
  table.set(name + "_mm", std::vector<double>{1000 * v.value});
  table.set(name + "_lo_mm", std::vector<double>{1000 * v.low});
  table.set(name + "_hi_mm", std::vector<double>{1000 * v.high});
}

std::string in_mm(const Interval& v) {
  if (!std::isfinite(v.value)) return "not measured";
  if (!std::isfinite(v.high)) return fmt::format("at least {:.1f} mm", 1000 * v.low);
  return fmt::format("{:.1f} mm ({:.1f} to {:.1f})", 1000 * v.value, 1000 * v.low, 1000 * v.high);
}

void set_places(Table& table, const TraitRow& row) {
  const auto set = [&](const char* name, double value) { table.set(name, std::vector<double>{value}); };
  const Eigen::Vector3d base = row.T_world_plant.translation();
  set("base_x_m", base.x());
  set("base_y_m", base.y());
  set("base_z_m", base.z());
  if (!(row.rectangle.length > 0)) return;
  const auto& corners = row.rectangle.corners;
  const auto in_world = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(row.T_world_plant * Eigen::Vector3d(p.x(), p.y(), 0));
  };
  const Eigen::Vector3d middle = (in_world(corners[0]) + in_world(corners[2])) / 2;
  const Eigen::Vector3d one = in_world(corners[1]) - in_world(corners[0]),
                        other = in_world(corners[2]) - in_world(corners[1]);
  const Eigen::Vector3d along = one.norm() >= other.norm() ? one : other;
  set("breadth_x_m", middle.x());
  set("breadth_y_m", middle.y());
  set("breadth_angle_deg", degrees(std::atan2(along.y(), along.x())));
}

}  // namespace

Table trait_table(const TraitRow& row) {
  Table t;
  t.set("plant_id", std::vector<std::string>{row.plant_id});
  set_interval(t, "height", row.height);
  set_interval(t, "breadth_length", row.length);
  set_interval(t, "breadth_width", row.width);
  set_interval(t, "stem_diameter", row.stem);
  t.set("stem_height_mm", std::vector<double>{1000 * row.stem_height});
  t.set("stem_method", std::vector<std::string>{row.stem_method});
  t.set("scale", std::vector<std::string>{row.scale_known ? "known" : "unknown"});
  t.set("state", std::vector<std::string>{"auto"});
  set_places(t, row);
  return t;
}

void set_volume(Table& traits, const std::optional<Interval>& volume_m3) {
  const Interval none{no_number, no_number, no_number};
  const auto& v = volume_m3 ? *volume_m3 : none;
  traits.set("stem_volume_cm3", std::vector<double>{1e6 * v.value});
  traits.set("stem_volume_lo_cm3", std::vector<double>{1e6 * v.low});
  traits.set("stem_volume_hi_cm3", std::vector<double>{1e6 * v.high});
}

std::string size_sentence(const TraitRow& row) {
  return "height " + in_mm(row.height) + ", breadth " + in_mm(row.length) + " x " + in_mm(row.width) + ", stem " +
         in_mm(row.stem);
}

Table stem_table(const std::optional<CloudStem>& cloud, const std::optional<StemFit>& fit,
                 const std::vector<StemStrip>& strips, double stem_height, const Interval& at_stem_height) {
  std::vector<double> height, x, y, z, diameter, lo, hi;
  std::vector<std::string> source;
  const auto add = [&](const StemCurve& curve, double at, double d, const char* from) {
    const Eigen::Vector3d p = curve.at(at);
    height.push_back(1000 * at);
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    diameter.push_back(1000 * d);
    lo.push_back(1000 * std::max(0.0, d + at_stem_height.low - at_stem_height.value));
    hi.push_back(1000 * (d + at_stem_height.high - at_stem_height.value));
    source.emplace_back(from);
  };
  if (fit && !strips.empty()) {
    double low = strips.front().z, high = low;
    for (const auto& s : strips) {
      low = std::min(low, s.z);
      high = std::max(high, s.z);
    }
    constexpr int sections = 12;
    for (int i = 0; i <= sections; ++i) {
      const double at = low + i * (high - low) / sections;
      add(fit->axis, at, fit->diameter + fit->taper * (at - stem_height), "contours");
    }
  } else if (cloud) {
    constexpr int sections = 12;
    for (int i = 0; i <= sections; ++i)
      add(cloud->curve, cloud->min_z + i * (cloud->max_z - cloud->min_z) / sections, 2 * cloud->radius, "cloud");
  }
  Table t;
  t.set("height_mm", height);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("z_m", z);
  t.set("diameter_mm", diameter);
  t.set("diameter_lo_mm", lo);
  t.set("diameter_hi_mm", hi);
  t.set("source", source);
  return t;
}

Table contour_table(const StripsFound& found, const ViewSource* views, const std::optional<StemFit>& fit) {
  std::vector<std::int64_t> view;
  std::vector<double> height, x1, y1, x2, y2, sigma, width, weight;
  std::vector<std::string> name;
  for (const auto& s : found.strips) {
    view.push_back(s.view);
    name.push_back(views != nullptr ? views->name(s.view) : "");
    height.push_back(1000 * s.z);
    x1.push_back(s.left.x());
    y1.push_back(s.left.y());
    x2.push_back(s.right.x());
    y2.push_back(s.right.y());
    sigma.push_back(s.sigma);
    width.push_back((s.right - s.left).norm());
    weight.push_back(fit ? s.weight : 0);
  }
  Table t;
  t.set("view", view);
  t.set("name", name);
  t.set("height_mm", height);
  t.set("left_x_px", x1);
  t.set("left_y_px", y1);
  t.set("right_x_px", x2);
  t.set("right_y_px", y2);
  t.set("point_spread_px", sigma);
  t.set("width_px", width);
  t.set("weight", weight);
  return t;
}

}  // namespace bole::plant
