#include "sim/core/plot/stem_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::sim {

using std::numbers::pi;

Eigen::Vector3d StemShape::axis(double h) const {
  const double wave = std::sin(pi * h / bow_length_m);
  const Eigen::Vector2d xy = lean * h + bow * wave;
  return foot + Eigen::Vector3d(xy.x(), xy.y(), h);
}

Eigen::Vector3d StemShape::tangent(double h) const {
  const double slope = pi / bow_length_m * std::cos(pi * h / bow_length_m);
  const Eigen::Vector2d xy = lean + bow * slope;
  return Eigen::Vector3d(xy.x(), xy.y(), 1).normalized();
}

Eigen::Matrix<double, 3, 2> StemShape::section_axes(double h) const {
  const Eigen::Vector3d t = tangent(h);
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = (Eigen::Vector3d::UnitX() - t.x() * t).normalized();
  axes.col(1) = t.cross(axes.col(0));
  return axes;
}

double StemShape::mean_radius(double h) const {
  const double above = std::max(0.0, height_m - h) / (height_m - 1.3);
  return radius_m * std::pow(above, taper_exponent) * (1 + flare * std::exp(-std::max(-0.5, h) / flare_length_m));
}

double StemShape::radius(double h, double theta) const {
  double series = 1;
  for (int k = 0; k < orders; ++k) {
    const auto i = static_cast<std::size_t>(k);
    series += amplitude[i] * std::cos((first_order + k) * theta + phase[i]);
  }
  series += lobe_amplitude * std::exp(-std::max(-0.5, h) / flare_length_m) * std::cos(lobes * theta + lobe_phase);
  return mean_radius(h) * series;
}

Eigen::Vector3d StemShape::surface(double h, double theta) const {
  return axis(h) + radius(h, theta) * (section_axes(h) * Eigen::Vector2d(std::cos(theta), std::sin(theta)));
}

double StemShape::height_along(double h0, double length_m) const {
  // ds/dh = |axis'(h)|, a mild function: the midpoint rule in millimetre steps is exact to far below a micrometre.
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(length_m) / 0.01)));
  const double ds = length_m / steps;
  double h = h0;
  for (int i = 0; i < steps; ++i) h += ds * tangent(h + 0.5 * ds).z();
  return h;
}

Girth hull_girth(std::vector<Eigen::Vector2d> points) {
  Girth girth;
  if (points.size() < 3) return girth;
  double twice_area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& a = points[i];
    const auto& b = points[(i + 1) % points.size()];
    const double cross = a.x() * b.y() - b.x() * a.y();
    twice_area += cross;
    girth.centroid += cross * (a + b);
  }
  girth.centroid /= 3 * twice_area;
  // Andrew's monotone chain.
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> hull(2 * points.size());
  std::size_t n = 0;
  const auto turns_right = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d u = hull[n - 1] - hull[n - 2], v = p - hull[n - 2];
    return u.x() * v.y() - u.y() * v.x() <= 0;
  };
  for (const auto& p : points) {
    while (n >= 2 && turns_right(p)) --n;
    hull[n++] = p;
  }
  const std::size_t lower = n + 1;
  for (auto it = points.rbegin() + 1; it != points.rend(); ++it) {
    while (n >= lower && turns_right(*it)) --n;
    hull[n++] = *it;
  }
  for (std::size_t i = 0; i + 1 < n; ++i) girth.length_m += (hull[i + 1] - hull[i]).norm();
  return girth;
}

TapedStem tape(const StemShape& stem, const Terrain& terrain, double breast_height_m) {
  TapedStem taped;
  taped.ground_z_m = terrain.height(stem.foot.x(), stem.foot.y());
  for (int i = 0; i < 36; ++i) {
    const double theta = 2 * pi * i / 36;
    // Where the bark meets the ground, a hand's breadth out: the ground that the forester stands on at the stem's upper
    // side.
    const Eigen::Vector2d p =
        stem.foot.head<2>() + (stem.radius(0, theta) + 0.05) * Eigen::Vector2d(std::cos(theta), std::sin(theta));
    taped.ground_z_m = std::max(taped.ground_z_m, terrain.height(p.x(), p.y()));
  }
  taped.h = stem.height_along(taped.ground_z_m - stem.foot.z(), breast_height_m);
  constexpr int samples = 720;
  std::vector<Eigen::Vector2d> section(samples);
  for (int i = 0; i < samples; ++i) {
    const double theta = 2 * pi * i / samples;
    section[static_cast<std::size_t>(i)] =
        stem.radius(taped.h, theta) * Eigen::Vector2d(std::cos(theta), std::sin(theta));
  }
  const Girth girth = hull_girth(section);
  // An inscribed polygon of n sides is short by (pi/n)^2 / 6: put back, so that a circle gives its own diameter.
  taped.diameter_m = girth.length_m / pi * (1 + pi * pi / (6.0 * samples * samples));
  taped.centre = stem.axis(taped.h) + stem.section_axes(taped.h) * girth.centroid;
  taped.axis = stem.tangent(taped.h);
  return taped;
}

}  // namespace bole::sim
