#include "stems/core/tree/stem_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/statistics.h"
#include "stems/core/detect/ring_density.h"
#include "stems/core/fit/circle_fit.h"
#include "stems/core/fit/each_stem.h"

namespace bole::stems {
namespace {

constexpr double step_m = 0.5, half_thickness_m = 0.10, margin_m = 0.12, widest_curve_gap_m = 2.0;
constexpr double sway = 0.10;  // metres per metre that a stem may leave its straight axis by

// Where the axis is expected, and how thick the stem is there.
struct Upwards {
  Eigen::Vector2d centre, slope;
  double z, radius, taper;
  Eigen::Vector2d at(double height) const { return centre + (height - z) * slope; }
};

std::optional<Section> section_at(const std::vector<Eigen::Vector3d>& near, const Upwards& up, double z,
                                  const MeasureOptions& options) {
  const double expected = std::max(0.02, up.radius + up.taper * (z - up.z));
  std::vector<Eigen::Vector2d> ring;
  for (const auto& p : near)
    if (std::abs(p.z() - z) <= half_thickness_m)
      if (const Eigen::Vector2d q = p.head<2>() - up.at(p.z()); q.norm() < expected + margin_m) ring.push_back(q);
  const auto fit = robust_circle(ring, {Eigen::Vector2d::Zero(), expected}, 0.05, options.max_sigma);
  if (!fit || fit->inliers < std::max(12, options.min_section_points) || fit->arc_rad < radians(options.min_arc_deg))
    return std::nullopt;
  const double r = fit->circle.radius, rise = z - up.z;
  if (std::abs(r - expected) > 0.01 + 0.2 * expected || fit->circle.centre.norm() > 0.02 + sway * rise)
    return std::nullopt;
  RingDensity density(r);
  for (const auto& q : ring) density.add((q - fit->circle.centre).norm() - r);
  if (density.contrast() < 3) return std::nullopt;
  Section s;
  const Eigen::Vector2d centre = up.at(z) + fit->circle.centre;
  s.centre = {centre.x(), centre.y(), z}, s.radius = r, s.sigma = fit->sigma, s.arc_rad = fit->arc_rad,
  s.inliers = fit->inliers, s.curve = true;
  return s;
}

void follow(Stem& stem, const std::vector<Eigen::Vector3d>& near, const MeasureOptions& options) {
  const Section* highest = nullptr;
  for (auto& s : stem.sections) {
    s.curve = s.used;
    if (s.used && (!highest || s.height > highest->height)) highest = &s;
  }
  if (!highest) return;
  const double cos_lean = stem.direction.z();
  Upwards up{highest->centre.head<2>(), stem.direction.head<2>() / cos_lean, highest->centre.z(), highest->radius,
             std::min(0.0, stem.taper)};
  for (double z = up.z + step_m; z - up.z <= widest_curve_gap_m; z += step_m) {
    auto section = section_at(near, up, z, options);
    if (!section) continue;
    section->height = (z - stem.ground_z) / cos_lean;
    const double rise = z - up.z;
    const Eigen::Vector2d seen = (section->centre.head<2>() - up.centre) / rise;
    up.slope += 0.3 * (seen - up.slope);
    up.taper = std::clamp(up.taper + 0.2 * ((section->radius - up.radius) / rise - up.taper), -0.02, 0.0);
    // The circle wanders within its noise; the expectation follows by half.
    up.centre = 0.5 * (up.at(z) + section->centre.head<2>()), up.z = z,
    up.radius += 0.5 * (section->radius - up.radius);
    stem.sections.push_back(*section);
  }
}

}  // namespace

void follow_stems(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, double breast_height_m,
                  const MeasureOptions& options, const Run& run, Report& report) {
  std::vector<std::vector<Eigen::Vector3d>> near(stems.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto id = static_cast<std::size_t>(labels.tree_id[i]);
    if (id == 0) continue;
    const Stem& s = stems[id - 1];
    const Eigen::Vector3d p = points.positions()[i].cast<double>();
    const double rise = p.z() - s.breast_height.z() - (s.highest - breast_height_m) * s.direction.z();
    if (rise < 0) continue;
    const Eigen::Vector2d axis =
        s.breast_height.head<2>() + (p.z() - s.breast_height.z()) / s.direction.z() * s.direction.head<2>();
    if ((p.head<2>() - axis).norm() < s.radius + margin_m + sway * rise) near[id - 1].push_back(p);
  }
  for_each_stem(
      stems, "the stem curve", run, report, [&](std::size_t k) { follow(stems[k], near[k], options); },
      [](Stem& s) {
        std::erase_if(s.sections, [&](const Section& c) { return c.curve && !c.used; });
        for (auto& c : s.sections) c.curve = false;
      });
}

std::vector<CurvePoint> stem_curve(const Stem& stem, double breast_height_m) {
  std::vector<CurvePoint> raw;
  std::vector<double> too_wide;
  for (const auto& s : stem.sections) {
    if (s.curve) raw.push_back({s.height, s.radius});
    if (s.used) too_wide.push_back(s.radius - stem.radius - stem.taper * (s.height - breast_height_m));
  }
  std::ranges::sort(raw, {}, &CurvePoint::height_m);
  if (too_wide.empty()) return raw;
  const double offset = upper_median(too_wide);
  auto curve = raw;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (i > 0 && i + 1 < raw.size()) {
      const double a = raw[i - 1].radius_m, b = raw[i].radius_m, c = raw[i + 1].radius_m;
      curve[i].radius_m = std::max(std::min(a, b), std::min(std::max(a, b), c));
    }
    curve[i].radius_m = std::max(0.005, curve[i].radius_m - offset);
  }
  return curve;
}

StemVolume volume_of(const std::vector<CurvePoint>& curve, double top_m) {
  const auto frustum = [](double length, double a, double b) {
    return std::numbers::pi / 3 * length * (a * a + a * b + b * b);
  };
  const auto &low = curve.front(), &high = curve.back();
  const double taper = (low.radius_m - high.radius_m) / std::max(0.1, high.height_m - low.height_m);
  StemVolume v;
  v.m3 = frustum(low.height_m, low.radius_m + std::max(0.0, taper) * low.height_m, low.radius_m);
  for (std::size_t i = 1; i < curve.size(); ++i)
    v.m3 += frustum(curve[i].height_m - curve[i - 1].height_m, curve[i - 1].radius_m, curve[i].radius_m);
  // Between a paraboloid (1) and a cone (2), as tables of volumes are: form factors of pines are 0.44 to 0.46.
  constexpr double power = 1.5;
  v.m3 += std::numbers::pi / (power + 1) * high.radius_m * high.radius_m * std::max(0.0, top_m - high.height_m);
  v.method = fmt::format("frustums to {:.1f} m, between paraboloid and cone above", high.height_m);
  return v;
}

void measure_volumes(std::vector<Stem>& stems, double breast_height_m, const Run& run, Report& report) {
  const auto measure = [&](std::size_t k) {
    auto& s = stems[k];
    const auto curve = stem_curve(s, breast_height_m);
    if (!s.height_seen || curve.size() < 2 || s.height_m <= curve.back().height_m) return;
    auto v = volume_of(curve, s.height_m);
    s.volume_m3 = v.m3, s.volume_method = std::move(v.method);
  };
  for_each_stem(stems, "the volume", run, report, measure,
                [](Stem& s) { s.volume_m3 = std::nan(""), s.volume_method.clear(); });
}

}  // namespace bole::stems
