#include "rows/core/rows/row_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"

namespace bole::rows {
namespace {

constexpr int plants_per_coefficient = 4;  // fewer would let a curve follow the scatter of the planting
constexpr Eigen::Index min_for_weights = 5;
constexpr double tukey = 4.7;   // sigmas beyond which a plant has no weight
constexpr int refinements = 2;  // of the lengths along the row by the fitted curve

}  // namespace

Eigen::Vector2d RowCurve::at(double t_m) const {
  const double t = std::clamp(t_m, 0.0, length_m_), s = t / scale_ - 1;
  Eigen::RowVector2d p = coefficients_.row(coefficients_.rows() - 1);
  for (auto i = coefficients_.rows() - 2; i >= 0; --i) p = p * s + coefficients_.row(i);
  return p.transpose() + (t_m - t) * tangent(t_m);
}

Eigen::Vector2d RowCurve::tangent(double t_m) const {
  const double s = std::clamp(t_m, 0.0, length_m_) / scale_ - 1;
  Eigen::RowVector2d d = Eigen::RowVector2d::Zero();
  for (auto i = coefficients_.rows() - 1; i >= 1; --i) d = d * s + static_cast<double>(i) * coefficients_.row(i);
  return d.transpose().normalized();
}

RowCurve::Foot RowCurve::foot(const Eigen::Vector2d& p) const {
  double t = (p - at(0)).dot((at(length_m_) - at(0)).normalized());
  for (int i = 0; i < 25; ++i) {
    const double step = (p - at(t)).dot(tangent(t));
    t += step;
    if (std::abs(step) < 1e-9 * (1 + length_m_)) break;
  }
  const Eigen::Vector2d u = tangent(t), d = p - at(t);
  return {t, u.x() * d.y() - u.y() * d.x()};
}

double RowCurve::sagitta_m() const {
  const Eigen::Vector2d a = at(0), u = (at(length_m_) - a).normalized();
  double largest = 0;
  for (int i = 1; i < 32; ++i) {
    const Eigen::Vector2d d = at(length_m_ * i / 32) - a;
    largest = std::max(largest, std::abs(u.x() * d.y() - u.y() * d.x()));
  }
  return largest;
}

// One degree: solve, measure the lengths and distances anew by the curve, and again with Tukey's weights.
RowCurve RowCurve::fit_degree(const Points2& in_order, int degree, std::vector<double> t) {
  const auto n = static_cast<Eigen::Index>(in_order.size());
  RowCurve curve;
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(n);
  for (int round = 0; round <= refinements; ++round) {
    const auto [first, last] = std::minmax_element(t.begin(), t.end());
    const double shift = *first;
    curve.length_m_ = std::max(*last - shift, 1e-9);
    curve.scale_ = curve.length_m_ / 2;
    Eigen::MatrixXd powers(n, degree + 1);
    Eigen::MatrixX2d xy(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      t[k] -= shift;
      for (int j = 0; j <= degree; ++j) powers(i, j) = std::pow(t[k] / curve.scale_ - 1, j) * weight[i];
      xy.row(i) = in_order[k].transpose() * weight[i];
    }
    curve.coefficients_ = powers.colPivHouseholderQr().solve(xy);
    std::vector<double> across;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const auto foot = curve.foot(in_order[i]);
      t[i] = foot.t_m;
      across.push_back(std::abs(foot.across_m));
    }
    curve.sigma_m_ = 1.4826 * upper_median(across);
    if (n < min_for_weights) continue;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double r = across[static_cast<std::size_t>(i)] / (tukey * std::max(curve.sigma_m_, 1e-9));
      weight[i] = r < 1 ? 1 - r * r : 0;
    }
    if ((weight.array() > 0).count() <= degree + 1) weight.setOnes();
  }
  return curve;
}

RowCurve RowCurve::fit(const Points2& in_order, int max_degree) {
  const auto n = static_cast<double>(in_order.size());
  RowCurve best;
  double best_score = std::numeric_limits<double>::infinity();
  for (int degree = 1; degree <= max_degree; ++degree) {
    if (degree > 1 && n < plants_per_coefficient * (degree + 1)) break;
    std::vector<double> t;
    const Eigen::Vector2d u = (in_order.back() - in_order.front()).normalized();
    for (const auto& p : in_order) t.push_back(degree == 1 ? (p - in_order.front()).dot(u) : best.foot(p).t_m);
    RowCurve curve = fit_degree(in_order, degree, std::move(t));
    double square_sum = 0;
    for (const auto& p : in_order) {
      const double a = std::min(std::abs(curve.foot(p).across_m), 4 * std::max(curve.sigma_m_, 1e-9));
      square_sum += a * a;
    }
    const double floor = 1e-12 * curve.length_m_ * curve.length_m_;
    const double score = n * std::log(square_sum / n + floor) + 2.0 * degree * std::log(n);
    if (score < best_score) {
      best = std::move(curve);
      best_score = score;
    } else if (degree > 2) {
      break;
    }  // an S may need the third degree before it pays
  }
  return best;
}

}  // namespace bole::rows
