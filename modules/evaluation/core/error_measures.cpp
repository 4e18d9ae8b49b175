#include "evaluation/core/error_measures.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/no_number.h"

namespace bole::evaluation {

double share_percent(double part, double whole) { return whole > 0 ? 100 * part / whole : no_number; }

PositionMeasures position_measures(const std::vector<Eigen::Vector2d>& errors) {
  PositionMeasures m;
  m.n = errors.size();
  if (errors.empty()) {
    m.mean.setConstant(no_number);
    m.covariance.setConstant(no_number);
    m.sigma = m.rmse = m.mean;
    m.max_sigma = m.correlation = no_number;
    return m;
  }
  const auto n = static_cast<double>(m.n);
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (const auto& e : errors) {
    m.mean += e;
    squares += e.cwiseAbs2();
  }
  m.mean /= n;
  m.rmse = (squares / n).cwiseSqrt();
  for (const auto& e : errors) m.covariance += (e - m.mean) * (e - m.mean).transpose() / n;
  m.sigma = m.covariance.diagonal().cwiseSqrt();
  m.max_sigma = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(m.covariance).eigenvalues()[1]);
  const double both = m.sigma.x() * m.sigma.y();
  m.correlation = both > 0 ? m.covariance(0, 1) / both : no_number;
  return m;
}

DiameterMeasures diameter_measures(const std::vector<DiameterPair>& pairs) {
  DiameterMeasures m;
  double sum = 0, squares = 0, relative = 0, relative_squares = 0, covered = 0;
  for (const auto& p : pairs) {
    const double error = p.estimate_cm - p.reference_cm;
    if (!std::isfinite(error) || !(p.reference_cm > 0)) continue;
    ++m.n;
    sum += error;
    squares += error * error;
    relative += error / p.reference_cm;
    relative_squares += error * error / (p.reference_cm * p.reference_cm);
    if (!std::isfinite(p.lo_cm) || !std::isfinite(p.hi_cm)) continue;
    ++m.with_interval;
    if (p.reference_cm >= p.lo_cm && p.reference_cm <= p.hi_cm) covered += 1;
  }
  const auto n = static_cast<double>(m.n);  // 0 / 0: NaN
  m.bias_cm = sum / n;
  m.relative_bias_pct = 100 * relative / n;
  m.rmse_cm = std::sqrt(squares / n);
  m.relative_rmse_pct = 100 * std::sqrt(relative_squares / n);
  m.coverage_pct = share_percent(covered, static_cast<double>(m.with_interval));
  return m;
}

}  // namespace bole::evaluation
