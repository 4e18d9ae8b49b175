#include "survey/core/post_centre.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "cloud/robust_mean.h"

namespace bole::survey {
namespace {

// Kasa (1976): x^2 + y^2 = 2 a x + 2 b y + c, about the mean of the points.
Eigen::Vector3d algebraic_circle(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * 1e-12;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - mean;
    const Eigen::Vector3d row(2 * d.x(), 2 * d.y(), 1);
    normal += row * row.transpose(), right += d.squaredNorm() * row;
  }
  const Eigen::Vector3d s = normal.ldlt().solve(right);
  return {mean.x() + s.x(), mean.y() + s.y(), std::sqrt(std::max(1e-6, s.z() + s.head<2>().squaredNorm()))};
}

double seen_share(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector3d& circle, double reach_m) {
  constexpr std::size_t sectors = 36;
  std::array<int, sectors> hits{};
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - circle.head<2>();
    if (std::abs(d.norm() - circle.z()) > reach_m) continue;
    const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 0.5;
    ++hits[std::min(sectors - 1, static_cast<std::size_t>(turn * sectors))];
  }
  return static_cast<double>(std::count_if(hits.begin(), hits.end(), [](int n) { return n >= 2; })) / sectors;
}

}  // namespace

PostFit fit_post(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights, double max_radius_m) {
  constexpr double min_radius_m = 0.02, min_sigma_m = 0.003;
  PostFit fit;
  if (points.size() < 10) return fit;
  Eigen::Vector3d circle = algebraic_circle(points);  // x, y, radius
  constexpr int iterations = 30;
  for (int it = 0; it < iterations; ++it) {
    std::vector<double> off;
    for (const auto& p : points) off.push_back(std::abs((p - circle.head<2>()).norm() - circle.z()));
    fit.residual_m = std::max(min_sigma_m, 1.4826 * upper_median(std::vector(off)));
    const double cut = 4.685 * fit.residual_m;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * 1e-9;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (off[i] >= cut) continue;
      const Eigen::Vector2d d = points[i] - circle.head<2>();
      const double r = d.norm(), u = off[i] / cut;
      const double w = (weights.empty() ? 1.0 : weights[i]) * (1 - u * u) * (1 - u * u);
      const Eigen::Vector3d row(-d.x() / std::max(r, 1e-9), -d.y() / std::max(r, 1e-9),
                                -1);  // derivative of r - radius
      normal += w * row * row.transpose(), right -= w * (r - circle.z()) * row;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    circle += step;
    if (!circle.allFinite() || circle.z() <= 0 || circle.z() > 10) return fit;
    if (step.norm() < 1e-6) break;
  }
  fit.centre = circle.head<2>(), fit.radius_m = circle.z();
  fit.valid = fit.radius_m >= min_radius_m && fit.radius_m <= max_radius_m && fit.residual_m < fit.radius_m / 3 &&
              seen_share(points, circle, 3 * fit.residual_m) >= 1.0 / 3;
  return fit;
}

}  // namespace bole::survey
