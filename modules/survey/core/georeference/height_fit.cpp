#include "survey/core/georeference/height_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "survey/core/georeference/blunders.h"

namespace bole::survey {
namespace {

double height_weight(const HeightPair& p) { return 1 / (p.sd_m * p.sd_m); }

std::vector<Eigen::Vector2d> plan_of(const std::vector<HeightPair>& pairs) {
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : pairs) plan.emplace_back(p.local.head<2>());
  return plan;
}

}  // namespace

bool spans_a_plane(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return false;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const auto& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  const double narrow = std::sqrt(std::max(0.0, axes.eigenvalues()(0))), wide = std::sqrt(axes.eigenvalues()(1));
  constexpr double min_ratio = 0.1;
  return wide > 0 && narrow >= min_ratio * wide;
}

double HeightFit::height_of(const Eigen::Vector3d& local) const {
  const Eigen::Vector3d d = local - centre_local;
  return centre_height_m + d.z() + rise.dot(d.head<2>());
}

Eigen::Matrix3d HeightFit::R_level_local() const {
  const Eigen::Vector3d up = Eigen::Vector3d(rise.x(), rise.y(), 1).normalized();
  return Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

HeightFit fit_heights(const std::vector<HeightPair>& pairs, const std::optional<double>& known_level_rad,
                      bool adjust_level) {
  if (pairs.empty()) throw bad_input("there is no control height", "at least one");
  HeightFit fit;
  double weight = 0, difference = 0;
  for (const auto& p : pairs) {
    const double w = height_weight(p);
    weight += w;
    fit.centre_local += w * p.local;
    difference += w * (p.height_m - p.local.z());
  }
  fit.centre_local /= weight;
  difference /= weight;
  fit.centre_height_m = fit.centre_local.z() + difference;
  fit.shift_se_m = 1 / std::sqrt(weight);
  constexpr double unknown_level_rad = 1;
  const double level_rad = known_level_rad.value_or(unknown_level_rad), known = 1 / (level_rad * level_rad);
  Eigen::Matrix2d normal = known * Eigen::Matrix2d::Identity();
  fit.levelled = adjust_level && spans_a_plane(plan_of(pairs));
  if (fit.levelled) {
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const auto& p : pairs) {
      const Eigen::Vector2d d = (p.local - fit.centre_local).head<2>();
      normal += height_weight(p) * d * d.transpose();
      right += height_weight(p) * d * (p.height_m - p.local.z() - difference);
    }
    fit.rise = normal.ldlt().solve(right);
    fit.chi2 += known * fit.rise.squaredNorm();
  }
  fit.rise_covariance = normal.inverse();
  for (const auto& p : pairs) {
    fit.residuals_m.push_back(p.height_m - fit.height_of(p.local));
    fit.chi2 += fit.residuals_m.back() * fit.residuals_m.back() * height_weight(p);
  }
  // A known level gives the rise as many observations as unknowns.
  fit.redundancy = static_cast<int>(pairs.size()) - (fit.levelled && !known_level_rad ? 3 : 1);
  return fit;
}

int height_blunder(const std::vector<HeightPair>& pairs, bool adjust_level, bool sd_stated) {
  if (pairs.size() < 4) return -1;
  double most = 1;
  int worst = -1;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    auto others = pairs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto fit = fit_heights(others, std::nullopt, adjust_level);
    const double freedom =
        sd_stated ? std::numeric_limits<double>::infinity() : assumed_freedom + std::max(0, fit.redundancy);
    const double unit2 = sd_stated ? 1 : (assumed_freedom + fit.chi2) / freedom;
    const Eigen::Vector2d arm = (pairs[i].local - fit.centre_local).head<2>();
    const double variance =
        pairs[i].sd_m * pairs[i].sd_m + fit.shift_se_m * fit.shift_se_m + arm.dot(fit.rise_covariance * arm);
    const double off = pairs[i].height_m - fit.height_of(pairs[i].local);
    // The limit of two degrees of freedom is a little wide for one.
    const double limit2 = 2 * unit2 * variance * f2_limit(0.001 / static_cast<double>(pairs.size()), freedom);
    if (const double ratio = std::abs(off) / std::sqrt(limit2); ratio > most) {
      most = ratio;
      worst = static_cast<int>(i);
    }
  }
  return worst;
}

}  // namespace bole::survey
