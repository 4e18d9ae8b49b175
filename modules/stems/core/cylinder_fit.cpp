#include "stems/core/cylinder_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "stems/core/circle_fit.h"

namespace bole {
namespace {

constexpr double smallest_sigma = 0.001;

double square(double v) { return v * v; }

class JointFit {
 public:
  JointFit(const std::vector<BarkPoint>& points, const CylinderFitOptions& options, std::size_t passes)
      : points_(points),
        options_(options),
        passes_(passes),
        size_(6 + (passes > 1 ? 2 * passes : 0)),
        information_(information_share()) {}

  bool solve(TaperedCylinder& c, double& scale) {
    double damping = 1e-4;
    for (int i = 0; i < 40; ++i) {
      choose_active(c);
      Eigen::MatrixXd normal;
      Eigen::VectorXd gradient;
      const double cost = assemble(c, scale, normal, gradient);
      if (!std::isfinite(cost)) return false;
      double step_norm = 0;
      bool moved = false;
      for (int attempt = 0; attempt < 6 && !moved; ++attempt) {
        Eigen::MatrixXd damped = normal;
        damped.diagonal() *= 1 + damping;
        const Eigen::VectorXd step = -damped.ldlt().solve(gradient);
        if (!step.allFinite()) return false;
        const auto next = moved_by(c, step);
        if (next.radius > 0.004 && cost_of(next, scale) <= cost) {
          c = next, step_norm = step.norm(), moved = true, damping = std::max(1e-9, damping * 0.3);
        } else {
          damping *= 10;
        }
      }
      const double found = robust_scale(c, scale);
      if (!std::isfinite(found)) return false;
      const double shrunk =
          std::clamp(std::max(found, 0.75 * scale), smallest_sigma, std::max(options_.max_sigma_m, 0.75 * scale));
      const bool settled = std::abs(shrunk - scale) < 1e-3 * scale;
      scale = shrunk;
      if (settled && (!moved || step_norm < 1e-6)) break;
    }
    return c.radius > 0.004 && std::abs(c.slope_x) < 1 && std::abs(c.slope_y) < 1;
  }

  void describe(CylinderFit& fit) const;
  DriftEvidence drift_evidence(const TaperedCylinder& c, const Eigen::MatrixXd& normal) const;

 private:
  // Which rays take part is settled between steps, not within: a gate that moved with the radius would pay for a larger
  // one.
  void choose_active(const TaperedCylinder& c) {
    active_.assign(points_.size(), true);
    if (!options_.along_rays) return;
    for (std::size_t i = 0; i < points_.size(); ++i)
      active_[i] = ray_residual(c, points_[i], options_.ray_gate, false).usable;
  }

  PointResidual residual(const TaperedCylinder& c, const BarkPoint& p) const {
    return options_.along_rays ? ray_residual(c, p, 0.998) : surface_residual(c, p);
  }
  PointResidual value(const TaperedCylinder& c, const BarkPoint& p) const {
    return options_.along_rays ? ray_residual(c, p, 0.998, false) : surface_residual(c, p, false);
  }

  // Points of one patch of bark seen in one pass err together: a patch counts as this many points at most.
  double information_share() const {
    constexpr double most_per_patch = 8;
    std::map<std::tuple<int, int, int>, int> patches;
    for (const auto& p : points_)
      ++patches[{p.pass, p.section,
                 static_cast<int>(std::floor(std::atan2(p.p.y(), p.p.x()) / (std::numbers::pi / 6)))}];
    return std::min(
        1.0, most_per_patch * static_cast<double>(patches.size()) / std::max(1.0, static_cast<double>(points_.size())));
  }

  // Tukey's loss of a squared residual in units of its cut-off, as a share of its highest value.
  static double rho(double u2) {
    const double rest = 1 - u2;
    return u2 >= 1 ? 1 : 1 - rest * rest * rest;
  }

  double prior_cost(const TaperedCylinder& c) const {
    double cost = square((c.taper - options_.taper_mean) / options_.taper_sd);
    if (passes_ > 1)
      for (const auto& o : c.pass_offset) cost += o.squaredNorm() / (options_.drift_sd_m * options_.drift_sd_m);
    return cost / 2;
  }

  // Tukey's rho in units of the scale, summed. An active ray that would miss the stem costs as an outlier.
  double cost_of(const TaperedCylinder& c, double scale) const {
    constexpr double k2 = 4.685 * 4.685;
    double sum = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!active_[i]) continue;
      const auto& p = points_[i];
      const auto e = value(c, p);
      const double u2 = e.usable ? e.value * e.value / (scale * scale * k2) : 1;
      sum += rho(u2);
    }
    return information_ * sum * k2 / 6 + prior_cost(c);
  }

  Eigen::VectorXd row_of(const PointResidual& e, const BarkPoint& p) const {
    Eigen::VectorXd j = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size_));
    j.head<6>() = e.jacobian;
    if (passes_ > 1) j.segment<2>(6 + 2 * p.pass) = e.jacobian.head<2>();
    return j;
  }

  void add_prior(const TaperedCylinder& c, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient) const {
    const double wt = 1 / (options_.taper_sd * options_.taper_sd);
    normal(5, 5) += wt, gradient[5] += wt * (c.taper - options_.taper_mean);
    if (passes_ < 2) return;
    const double wd = 1 / (options_.drift_sd_m * options_.drift_sd_m);
    for (std::size_t k = 0; k < passes_; ++k) {
      const auto at = static_cast<Eigen::Index>(6 + 2 * k);
      normal.diagonal().segment<2>(at).array() += wd;
      gradient.segment<2>(at) += wd * c.pass_offset[k];
    }
  }

  double assemble(const TaperedCylinder& c, double scale, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient) const {
    const auto n = static_cast<Eigen::Index>(size_);
    normal = Eigen::MatrixXd::Zero(n, n), gradient = Eigen::VectorXd::Zero(n);
    // Small blocks per pass: the offsets of two passes never meet in one point.
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    std::vector<Matrix6> by_pass(passes_, Matrix6::Zero());
    std::vector<Eigen::Matrix<double, 6, 1>> rhs(passes_, Eigen::Matrix<double, 6, 1>::Zero());
    constexpr double k2 = 4.685 * 4.685;
    double sum = 0;
    const double factor = information_ / (scale * scale);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!active_[i]) continue;
      const auto& p = points_[i];
      const auto e = residual(c, p);
      const double u2 = e.usable ? e.value * e.value / (scale * scale * k2) : 1;
      sum += rho(u2);
      if (u2 >= 1) continue;
      const double w = factor * (1 - u2) * (1 - u2);
      const auto k = static_cast<std::size_t>(p.pass);
      by_pass[k].noalias() += w * e.jacobian * e.jacobian.transpose();
      rhs[k] += w * e.value * e.jacobian;
    }
    for (std::size_t k = 0; k < passes_; ++k) {
      normal.topLeftCorner<6, 6>() += by_pass[k], gradient.head<6>() += rhs[k];
      if (passes_ < 2) continue;
      const auto at = static_cast<Eigen::Index>(6 + 2 * k);
      normal.block<2, 6>(at, 0) += by_pass[k].topRows<2>(), normal.block<6, 2>(0, at) += by_pass[k].leftCols<2>();
      normal.block<2, 2>(at, at) += by_pass[k].topLeftCorner<2, 2>(), gradient.segment<2>(at) += rhs[k].head<2>();
    }
    add_prior(c, normal, gradient);
    return information_ * sum * k2 / 6 + prior_cost(c);
  }

  TaperedCylinder moved_by(TaperedCylinder c, const Eigen::VectorXd& step) const {
    c.x += step[0], c.y += step[1], c.slope_x += step[2], c.slope_y += step[3], c.radius += step[4], c.taper += step[5];
    if (passes_ > 1)
      for (std::size_t k = 0; k < passes_; ++k)
        c.pass_offset[k] += step.segment<2>(static_cast<Eigen::Index>(6 + 2 * k));
    return c;
  }

  double robust_scale(const TaperedCylinder& c, double scale) const {
    std::vector<double> errors;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (const auto e = value(c, points_[i]); active_[i] && e.usable && std::abs(e.value) < 4.685 * scale)
        errors.push_back(std::abs(e.value));
    return 1.4826 * median_of(errors);
  }

  const std::vector<BarkPoint>& points_;
  const CylinderFitOptions& options_;
  std::vector<bool> active_;
  std::size_t passes_;
  std::size_t size_;
  double information_;
};

DriftEvidence JointFit::drift_evidence(const TaperedCylinder& c, const Eigen::MatrixXd& normal) const {
  const auto m = static_cast<Eigen::Index>(2 * passes_);
  Eigen::MatrixXd base = normal.topLeftCorner(6, 6);
  base(5, 5) += 1 / square(options_.taper_sd);
  base.diagonal() *= 1 + 1e-9;
  const Eigen::MatrixXd mixed = normal.block(0, 6, 6, m);
  DriftEvidence out;
  out.information = normal.bottomRightCorner(m, m) - mixed.transpose() * base.ldlt().solve(mixed);
  Eigen::VectorXd offset(m);
  for (std::size_t k = 0; k < passes_; ++k) offset.segment<2>(static_cast<Eigen::Index>(2 * k)) = c.pass_offset[k];
  // At the optimum the prior and the data balance.
  out.target = out.information * offset + offset / square(options_.drift_sd_m);
  return out;
}

// Covariance by the block sandwich: H^-1 (sum over blocks of g g^T) H^-1, where residuals within a block may be
// correlated at will. Two ways to block are tried, by pass and section and by pass and bearing (bark, section shape),
// and the larger variance is kept.
void JointFit::describe(CylinderFit& fit) const {
  const auto& c = fit.cylinder;
  const auto n = static_cast<Eigen::Index>(size_);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(n);
  std::map<std::pair<int, int>, Eigen::VectorXd> by_section, by_bearing;
  fit.weight.assign(points_.size(), 0);
  const double s2 = fit.sigma_m * fit.sigma_m;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!active_[i]) continue;
    const auto& p = points_[i];
    const auto e = residual(c, p);
    const double u = e.value / (4.685 * fit.sigma_m);
    if (!e.usable || std::abs(u) >= 1) continue;
    const double w = (1 - u * u) * (1 - u * u);
    fit.weight[i] = w, ++fit.inliers;
    const Eigen::VectorXd j = row_of(e, p);
    normal += information_ * (1 - u * u) * (1 - 5 * u * u) / s2 * j * j.transpose();
    const Eigen::VectorXd g = information_ * w * e.value / s2 * j;
    const auto bearing =
        static_cast<int>(std::floor(std::atan2(p.p.y() - c.y, p.p.x() - c.x) / (std::numbers::pi / 6)));
    auto& a = by_section.try_emplace({p.pass, p.section}, Eigen::VectorXd::Zero(n)).first->second;
    auto& b = by_bearing.try_emplace({p.pass, bearing}, Eigen::VectorXd::Zero(n)).first->second;
    a += g, b += g;
  }
  Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(n, n);
  add_prior(c, prior, unused);
  const Eigen::MatrixXd inverse = (normal + prior).ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const auto covariance = [&](const auto& blocks) -> Eigen::MatrixXd {
    Eigen::MatrixXd meat = prior;
    const auto count = static_cast<double>(blocks.size());
    for (const auto& [key, g] : blocks) meat += count / std::max(1.0, count - 1) * g * g.transpose();
    return inverse * meat * inverse.transpose();
  };
  const Eigen::MatrixXd first = covariance(by_section), second = covariance(by_bearing);
  const bool section_wins = first(4, 4) >= second(4, 4);
  const Eigen::MatrixXd& worse = section_wins ? first : second;
  fit.blocks = static_cast<int>(section_wins ? by_section.size() : by_bearing.size());
  fit.radius_sd_m = std::sqrt(std::max(0.0, worse(4, 4)));
  fit.position_sd_m = std::sqrt(std::max({0.0, worse(0, 0), worse(1, 1)}));
  if (passes_ > 1) fit.drift = drift_evidence(c, normal);
}

}  // namespace

double drift_log_likelihood(const DriftEvidence& evidence, double drift_sd_m) {
  const auto n = evidence.target.size();
  const double variance = square(drift_sd_m);
  const Eigen::MatrixXd posterior = evidence.information + Eigen::MatrixXd::Identity(n, n) / variance;
  const Eigen::LDLT<Eigen::MatrixXd> solver(posterior);
  return 0.5 * evidence.target.dot(solver.solve(evidence.target)) -
         0.5 * (solver.vectorD().cwiseMax(1e-300).array().log().sum() + static_cast<double>(n) * std::log(variance));
}

std::optional<CylinderFit> fit_tapered_cylinder(const std::vector<BarkPoint>& points, TaperedCylinder start,
                                                double start_error_m, const CylinderFitOptions& options) {
  if (points.size() < 12 || !(start.radius > 0)) return std::nullopt;
  int passes = 1;
  for (const auto& p : points) passes = std::max(passes, p.pass + 1);
  if (passes > 1)
    start.pass_offset.resize(static_cast<std::size_t>(passes), Eigen::Vector2d::Zero());
  else
    start.pass_offset.clear();
  JointFit joint(points, options, static_cast<std::size_t>(passes));
  CylinderFit fit;
  fit.cylinder = start, fit.along_rays = options.along_rays;
  fit.sigma_m = std::max(start_error_m / 2, options.max_sigma_m);
  if (!joint.solve(fit.cylinder, fit.sigma_m)) return std::nullopt;
  joint.describe(fit);
  if (fit.inliers < 12) return std::nullopt;
  return fit;
}

}  // namespace bole
