#include "plant/core/leaves/axis_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/no_number.h"
#include "base/statistics.h"

namespace bole::plant {
namespace {

void set_arc(AxisCurve& curve) {
  curve.arc.assign(curve.places.size(), 0);
  for (std::size_t i = 1; i < curve.places.size(); ++i)
    curve.arc[i] = curve.arc[i - 1] + (curve.places[i] - curve.places[i - 1]).norm();
}

std::pair<std::size_t, double> section_at(const AxisCurve& c, double along) {
  const auto above = std::ranges::upper_bound(c.arc, along) - c.arc.begin();
  const auto i =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(c.arc.size()) - 2));
  return {i, (along - c.arc[i]) / (c.arc[i + 1] - c.arc[i])};
}

// Local straight lines over the length, by least squares with Gaussian weights; stations far from theirs count less.
AxisCurve smoothed(const Points3& stations, const AxisScales& s) {
  std::vector<double> along(stations.size(), 0), weight(stations.size(), 1);
  for (std::size_t i = 1; i < stations.size(); ++i) along[i] = along[i - 1] + (stations[i] - stations[i - 1]).norm();
  const auto place = [&](double t) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero(), b = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const double u = (along[i] - t) / s.smooth;
      if (std::abs(u) > 4) continue;
      const double w = weight[i] * std::exp(-0.5 * u * u);
      const Eigen::Vector3d row(1, u, u * u);
      a += w * row * row.transpose();
      b += w * row * stations[i].transpose();
    }
    const double all = a(0, 0);
    a(0, 0) += 1e-9 * all + 1e-12;
    a(1, 1) += 0.01 * all + 1e-12;
    a(2, 2) += 0.5 * all + 1e-12;
    return Eigen::Vector3d(a.ldlt().solve(b).row(0).transpose());
  };
  for (int round = 0; round < 4; ++round) {
    std::vector<double> off(stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) off[i] = (stations[i] - place(along[i])).norm();
    const double scale = std::max(1.5 * median(off), 1e-9);
    for (std::size_t i = 0; i < stations.size(); ++i) weight[i] = 1 / (1 + std::pow(off[i] / (2 * scale), 4));
  }
  AxisCurve out;
  const int steps = std::max(1, static_cast<int>(std::ceil(along.back() / s.step)));
  for (int i = 0; i <= steps; ++i) out.places.push_back(place(along.back() * i / steps));
  set_arc(out);
  return out;
}

struct Station {
  Eigen::Vector3d middle;
  double radius = no_number;
};

// Middle of the points in a slice across the axis, found by moving to their mean.
Station station_at(const PointGrid& grid, const Points3& points, const Eigen::Vector3d& place,
                   const Eigen::Vector3d& along, double half_slice, double max_radius) {
  Points3 slice;
  grid.near(place, std::hypot(half_slice, 1.6 * max_radius), [&](std::uint32_t i, double) {
    const Eigen::Vector3d d = points[i] - place;
    if (std::abs(d.dot(along)) < half_slice) slice.push_back(d - d.dot(along) * along);
  });
  Station out{place, no_number};
  if (slice.size() < 6) return out;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int round = 0; round < 6; ++round) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (const auto& d : slice) {
      const double u = (d - middle).norm() / max_radius;
      const double w = u < 1 ? (1 - u * u) : 0;
      total += w;
      sum += w * d;
    }
    if (!(total > 0)) return out;
    middle = sum / total;
  }
  std::vector<double> radii;
  for (const auto& d : slice)
    if (const double r = (d - middle).norm(); r < max_radius) radii.push_back(r);
  if (radii.size() < 6) return out;
  out.middle = place + middle;
  out.radius = median(std::move(radii));
  return out;
}

}  // namespace

Eigen::Vector3d AxisCurve::at(double along) const {
  const auto [i, s] = section_at(*this, along);
  return (1 - s) * places[i] + s * places[i + 1];
}

Eigen::Vector3d AxisCurve::tangent(double along, double reach) const {
  const double from = std::max(0.0, along - reach), to = std::min(length(), along + reach);
  return to > from ? Eigen::Vector3d((at(to) - at(from)).normalized()) : (places.back() - places.front()).normalized();
}

double AxisCurve::radius_at(double along) const {
  double best = std::numeric_limits<double>::infinity(), radius = no_number;
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (std::isfinite(radii[i]) && std::abs(arc[i] - along) < best) {
      best = std::abs(arc[i] - along);
      radius = radii[i];
    }
  return radius;
}

AxisCurve::Nearest AxisCurve::nearest(const Eigen::Vector3d& place) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Eigen::Vector3d d = places[i + 1] - places[i];
    const double s = std::clamp((place - places[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double distance = (place - places[i] - s * d).norm();
    if (distance < best.distance) best = {arc[i] + s * (arc[i + 1] - arc[i]), distance};
  }
  return best;
}

AxisCurve extended(const AxisCurve& curve, double length, double look) {
  AxisCurve out = curve;
  if (curve.empty() || !(length > 0)) return out;
  const double reach = std::min(look, curve.length()) / 2;
  const Eigen::Vector3d along = curve.tangent(curve.length() - reach, reach);
  const double step = curve.length() / static_cast<double>(curve.places.size() - 1);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 1; i <= steps; ++i) {
    out.places.emplace_back(curve.places.back() + length * i / steps * along);
    out.arc.push_back(curve.length() + length * i / steps);
    out.radii.push_back(no_number);
  }
  return out;
}

AxisCurve axis_curve(const Points3& middles, const Points3& points, const AxisScales& scales) {
  AxisCurve curve;
  if (middles.size() < 3) {
    curve.places = middles;
    set_arc(curve);
    if (curve.length() <= 0) curve = {};
    curve.radii.assign(curve.places.size(), no_number);
    return curve;
  }
  curve = smoothed(middles, scales);
  const PointGrid grid(points, scales.max_radius);
  double max_radius = scales.max_radius;
  for (int round = 0; round < 4; ++round) {
    Points3 stations;
    std::vector<double> radii;
    for (std::size_t i = 0; i < curve.places.size(); ++i) {
      const auto station = station_at(grid, points, curve.places[i], curve.tangent(curve.arc[i], 3 * scales.step),
                                      1.2 * scales.step, max_radius);
      stations.push_back(station.middle);
      radii.push_back(station.radius);
    }
    auto finite = radii;
    std::erase_if(finite, [](double r) { return !std::isfinite(r); });
    curve = smoothed(stations, scales);
    curve.radii.assign(curve.places.size(), no_number);
    for (std::size_t i = 0; i < std::min(radii.size(), curve.radii.size()); ++i) curve.radii[i] = radii[i];
    if (!finite.empty()) max_radius = std::min(scales.max_radius, 2 * median(finite) + 0.5 * scales.step);
  }
  return curve;
}

}  // namespace bole::plant
