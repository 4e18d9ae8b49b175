#include "rows/core/frame/trunk_face.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/statistics.h"

namespace bole::rows {
namespace {

constexpr int min_points = 12;
constexpr double lean_sigma = 0.035;  // prior of the lean, metres per metre: 2 degrees
constexpr int iterations = 8;
constexpr double thick_sigmas = 3;  // radii that the curve of the face can tell

double tukey(double residual, double cut) {
  const double s = residual / cut;
  return std::abs(s) < 1 ? (1 - s * s) * (1 - s * s) : 0;
}

// Half width of a strip that is evenly filled to its edges, from distances to its middle: twice their median, or root
// three times their root mean square, which is twice as sharp, where no leaves make the two differ.
double radius_of_strip(const std::vector<double>& off) {
  double square = 0;
  for (const double d : off) square += d * d / static_cast<double>(off.size());
  const double by_median = 2 * upper_median(std::vector<double>(off)), by_square = std::sqrt(3 * square);
  return std::abs(by_square - by_median) < 0.12 * by_median ? by_square : by_median;
}

// Weighted line y = at0 + slope h with a prior on the slope; `sigma` scales the prior against the residuals.
struct HeightLine {
  double at0 = 0, slope = 0;
  double at(double h) const { return at0 + slope * h; }
};

HeightLine fit_line(const std::vector<double>& h, const std::vector<double>& y, const std::vector<double>& w,
                    double sigma) {
  Eigen::Matrix2d N = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  N(1, 1) = sigma * sigma / (lean_sigma * lean_sigma);
  for (std::size_t i = 0; i < h.size(); ++i) {
    const Eigen::Vector2d a(1, h[i]);
    N += w[i] * a * a.transpose();
    b += w[i] * y[i] * a;
  }
  const Eigen::Vector2d x = N.ldlt().solve(b);
  return {x[0], x[1]};
}

// A thick trunk shows its curve: circle by Gauss-Newton on the ranges, so that what hides a part of its width does not
// move it.
void refine_circle(const std::vector<double>& u, const std::vector<double>& v, const std::vector<double>& h,
                   double max_radius, double sigma_m, HeightLine& across, HeightLine& face, double& radius) {
  HeightLine a = across, f = face;
  double r = radius;
  for (int round = 0; round < 15; ++round) {
    Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    // The half width of the strip is a weak prior, because it is too small where a part is hidden.
    const double prior = 1 / (0.1 * radius * 0.1 * radius) * sigma_m * sigma_m;
    N(2, 2) += prior;
    b[2] += prior * (radius - r);
    double used = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double du = u[i] - a.at(h[i]);
      if (std::abs(du) > 0.92 * r) continue;
      const double depth = std::sqrt(r * r - du * du), e = v[i] - (f.at(h[i]) - depth);
      const double w = tukey(e, 4.5 * sigma_m);
      const Eigen::Vector3d J(-du / depth, 1, -r / depth);
      N += w * J * J.transpose();
      b += w * e * J;
      used += w;
    }
    if (used < min_points) return;
    const Eigen::Vector3d step = N.ldlt().solve(b);
    a.at0 += step[0];
    f.at0 += step[1];
    r += step[2];
    if (!(r > 0.3 * radius && r <= max_radius && std::abs(a.at0 - across.at0) < radius)) return;
    if (step.norm() < 1e-5) {
      across = a;
      face = f;
      radius = r;
      return;
    }
  }
}

}  // namespace

std::optional<TrunkFace> fit_trunk_face(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector2d& start,
                                        double max_diameter, double range_sigma) {
  if (!(start.norm() > 0) || std::ssize(points) < min_points) return {};
  const Eigen::Vector2d ahead = start.normalized(), left(-ahead.y(), ahead.x());
  const std::size_t n = points.size();
  std::vector<double> u(n), v(n), h(n);
  double mean_height = 0;
  for (const auto& p : points) mean_height += p.z() / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d d = points[i].head<2>() - start;
    u[i] = d.dot(left);
    v[i] = d.dot(ahead);
    h[i] = points[i].z() - mean_height;
  }
  HeightLine across{upper_median(std::vector<double>(u)), 0}, face{upper_median(std::vector<double>(v)), 0};
  double radius = max_diameter / 2;
  std::vector<double> wu(n), wv(n), back(n);
  for (int round = 0; round < iterations; ++round) {
    const double reach = 1.2 * radius + 0.004, depth = 4.5 * range_sigma + (round < 3 ? radius : 0);
    std::vector<double> off;
    for (std::size_t i = 0; i < n; ++i) {
      const double du = u[i] - across.at(h[i]), inside = std::min(std::abs(du), radius);
      back[i] = v[i] + std::sqrt(radius * radius - inside * inside);
      const double dv = back[i] - face.at(h[i]) - (round == 0 ? radius : 0);
      wv[i] = std::abs(du) < reach ? tukey(dv, depth + 1e-9) : 0;
      wu[i] = std::abs(du) < reach && std::abs(dv) < depth ? 1 : 0;
      if (wu[i] > 0) off.push_back(std::abs(du));
    }
    if (std::ssize(off) < min_points) return {};
    across = fit_line(h, u, wu, radius / 1.73);
    face = fit_line(h, back, wv, range_sigma);
    const double half = std::min(radius_of_strip(off), max_diameter / 2);
    radius = round < 2 ? std::max(half, 0.5 * radius) : half;
  }
  TrunkFace found;
  if (radius > thick_sigmas * range_sigma) refine_circle(u, v, h, max_diameter / 2, range_sigma, across, face, radius);
  double count = 0;
  for (const double w : wu) count += w;
  found.centre = start + across.at0 * left + face.at0 * ahead;
  found.radius_m = radius;
  found.lateral_se_m = radius / std::sqrt(3 * count);
  found.points = static_cast<int>(count);
  return found;
}

UprightStrip find_upright(const std::vector<Eigen::Vector3d>& points, double max_diameter, double range_sigma,
                          double layer_height) {
  constexpr std::size_t per_layer = 6;  // candidates
  struct Layer {
    std::vector<Eigen::Vector2d> points;
  };
  std::map<std::int64_t, Layer> layers;
  for (const auto& p : points)
    layers[static_cast<std::int64_t>(std::floor(p.z() / layer_height))].points.push_back(p.head<2>());
  UprightStrip best;
  std::size_t best_points = 0;
  for (const auto& [height, layer] : layers) {
    const std::size_t step = std::max<std::size_t>(1, layer.points.size() / per_layer);
    for (std::size_t c = 0; c < layer.points.size(); c += step) {
      const Eigen::Vector2d ahead = layer.points[c].normalized();
      UprightStrip strip;
      std::size_t count = 0;
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      std::int64_t low = 0, high = 0;
      for (const auto& [h, other] : layers) {
        std::size_t here = 0;
        for (const auto& q : other.points) {
          const Eigen::Vector2d d = q - layer.points[c];
          const double along = d.dot(ahead), across = std::abs(d.x() * ahead.y() - d.y() * ahead.x());
          if (across > max_diameter / 2 || std::abs(along) > max_diameter / 2 + 2.5 * range_sigma) continue;
          ++here;
          sum += q;
        }
        if (here == 0) continue;
        if (strip.layers++ == 0) low = h;
        high = h;
        count += here;
      }
      if (std::pair(strip.layers, count) <= std::pair(best.layers, best_points)) continue;
      strip.at = sum / static_cast<double>(count);
      strip.low_m = static_cast<double>(low) * layer_height,
      strip.high_m = static_cast<double>(high + 1) * layer_height;
      strip.filled = static_cast<double>(strip.layers) / static_cast<double>(high - low + 1);
      best = strip;
      best_points = count;
    }
  }
  return best;
}

}  // namespace bole::rows
