#include "stems/core/fit/cylinder_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

constexpr double smallest_sigma = 0.001;
constexpr double max_gate = 1.2;  // of rays that were let in at the start of a step

double square(double v) { return v * v; }

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;
using Vector8 = Eigen::Matrix<double, 8, 1>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

// Inverse covariance of the offsets of all views, one axis: views of a pass share the displacement of the pass.
struct DriftPrecision {
  Eigen::MatrixXd matrix;
  double log_determinant = 0;

  DriftPrecision(const std::vector<int>& pass_of_view, const DriftPrior& prior) {
    const auto n = static_cast<Eigen::Index>(pass_of_view.size());
    matrix = Eigen::MatrixXd::Zero(n, n);
    const double view = square(prior.view_sd_m), pass = square(prior.pass_sd_m);
    for (Eigen::Index first = 0; first < n;) {
      Eigen::Index last = first;  // views are in the order of their passes
      while (last < n && pass_of_view[static_cast<std::size_t>(last)] == pass_of_view[static_cast<std::size_t>(first)])
        ++last;
      const Eigen::Index m = last - first;
      const double together = view + static_cast<double>(m) * pass;
      matrix.block(first, first, m, m).diagonal().array() = 1 / view;
      matrix.block(first, first, m, m).array() -= pass / (view * together);
      log_determinant -= static_cast<double>(m - 1) * std::log(view) + std::log(together);
      first = last;
    }
  }
};

// Means over the views of each pass.
std::vector<Eigen::Vector2d> means_by_pass(const std::vector<int>& pass_of_view, const Eigen::VectorXd& offsets) {
  std::vector<Eigen::Vector2d> mean;
  std::vector<int> views;
  for (std::size_t k = 0; k < pass_of_view.size(); ++k) {
    const auto pass = static_cast<std::size_t>(pass_of_view[k]);
    if (views.size() <= pass) views.resize(pass + 1, 0), mean.resize(pass + 1, Eigen::Vector2d::Zero());
    ++views[pass], mean[pass] += (offsets.segment<2>(static_cast<Eigen::Index>(2 * k)) - mean[pass]) / views[pass];
  }
  return mean;
}

// Sums over the points on the range stretch, which is no parameter of the fit.
struct StretchSums {
  using Blocks = std::map<std::pair<int, int>, Eigen::VectorXd>;  // by pass and bearing, the pull on the parameters

  explicit StretchSums(Eigen::Index parameters) : cross(Eigen::VectorXd::Zero(parameters)) {}

  // One Newton step from a stretch of zero, with all parameters free to move along but the range offset: what stems say
  // of that is how strongly they seem to curve, and its error of several millimetres would pass for a stretch where
  // ranges differ little. `hessian` with the priors of the fit, at whose optimum the sums were taken.
  RangeStretchEvidence evidence(Eigen::MatrixXd hessian, double range_offset_m, const Blocks& blocks,
                                const Eigen::VectorXd& parameters_by_beam) const {
    constexpr double offset_sd_m = 0.001;
    hessian(6, 6) += 1 / square(offset_sd_m);
    const Eigen::VectorXd gain = hessian.ldlt().solve(cross);
    const double information = curvature - cross.dot(gain);
    if (!(information > 1e-9 * curvature) || blocks.size() < 2) return {};
    double sum = 0, meat = 0;
    const auto count = static_cast<double>(blocks.size());
    for (const auto& [key, g] : blocks) {
      const double own = pull.at(key);
      sum += own, meat += count / (count - 1) * square(own - gain.dot(g));
    }
    const double by_offset = gain[6] / square(offset_sd_m);
    return {(by_offset * range_offset_m - sum) / information,
            std::sqrt(std::max(meat / information, 1.0) / information),
            std::hypot(by_beam - gain.dot(parameters_by_beam), by_offset * offset_sd_m) / information};
  }

  Eigen::VectorXd cross;  // second derivatives by the stretch and each parameter
  double curvature = 0, by_beam = 0;
  std::map<std::pair<int, int>, double> pull;
};

class JointFit {
 public:
  JointFit(const std::vector<BarkPoint>& points, const CylinderFitOptions& options, std::vector<int> pass_of_view)
      : points_(points),
        options_(options),
        pass_of_view_(std::move(pass_of_view)),
        views_(pass_of_view_.size()),
        size_(7 + (views_ > 1 ? 2 * views_ : 0)),
        drift_(pass_of_view_, options.drift),
        information_(information_share()) {}

  bool solve(TaperedCylinder& c, double& scale, double& found_scale) {
    double damping = 1e-4;
    evaluate(c, values_);
    for (int i = 0; i < 40; ++i) {
      if (options_.cancel.stop_requested()) return false;
      choose_shares();
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
          values_.swap(tried_);
          c = next, step_norm = step.norm(), moved = true, damping = std::max(1e-9, damping * 0.3);
        } else {
          damping *= 10;
        }
      }
      const double found = robust_scale(scale);
      if (!std::isfinite(found)) return false;
      found_scale = found;
      const double shrunk =
          std::clamp(std::max(found, 0.75 * scale), smallest_sigma, std::max(options_.max_sigma, 0.75 * scale));
      const bool settled = std::abs(shrunk - scale) < options_.still_scale * scale;
      scale = shrunk;
      if (settled && (!moved || step_norm < options_.still_m)) break;
    }
    return c.radius > 0.004 && std::abs(c.slope_x) < 1 && std::abs(c.slope_y) < 1;
  }

  void describe(CylinderFit& fit) const;
  DriftEvidence drift_evidence(const TaperedCylinder& c, const Eigen::MatrixXd& normal) const;

 private:
  // How much a ray takes part is settled between steps, not within: a gate that moved with the radius would pay for a
  // larger one. Rays near the gate take part by degrees, so that the fit does not swing between two choices of them.
  void choose_shares() {
    share_.assign(points_.size(), 1);
    if (!options_.along_rays) return;
    for (std::size_t i = 0; i < points_.size(); ++i) share_[i] = values_[i].usable ? gate_share(values_[i].impact) : 0;
  }

  double gate_share(double impact) const {
    constexpr double half_width = 0.03;  // of the radius
    const double u = std::clamp((impact - options_.ray_gate) / half_width, -1.0, 1.0);
    return 0.5 - 0.25 * u * (3 - u * u);
  }

  struct Value {
    double value = 0, impact = 0;
    bool usable = false;
  };

  void evaluate(const TaperedCylinder& c, std::vector<Value>& values) const {
    values.resize(points_.size());
    const CylinderResiduals of(c);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto e = residual(of, points_[i], false);
      values[i] = {e.value, e.impact, e.usable};
    }
  }

  PointResidual residual(const CylinderResiduals& of, const BarkPoint& p, bool derivatives) const {
    return options_.along_rays ? of.along_ray(p, max_gate, derivatives) : of.surface(p, derivatives);
  }

  // Points of one patch of bark seen in one pass err together: a patch counts as this many points at most.
  double information_share() const {
    constexpr double max_per_patch = 8;
    constexpr std::int64_t bearings = 16, sections = std::int64_t{1} << 24;
    std::vector<std::int64_t> patches;
    patches.reserve(points_.size());
    for (const auto& p : points_)
      patches.push_back((p.pass * sections + p.section) * bearings +
                        static_cast<std::int64_t>(std::floor(std::atan2(p.p.y(), p.p.x()) / (std::numbers::pi / 6))));
    std::ranges::sort(patches);
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    return std::min(
        1.0, max_per_patch * static_cast<double>(patches.size()) / std::max(1.0, static_cast<double>(points_.size())));
  }

  // Tukey's loss of a squared residual in units of its cut-off, as a share of its highest value.
  static double rho(double u2) {
    const double rest = 1 - u2;
    return u2 >= 1 ? 1 : 1 - rest * rest * rest;
  }

  double prior_cost(const TaperedCylinder& c) const {
    double cost = square((c.taper - options_.taper_mean) / options_.taper_sd) +
                  square((c.range_offset - options_.range_offset.mean_m) / options_.range_offset.sd_m);
    if (views_ > 1)
      for (int axis = 0; axis < 2; ++axis) {
        const Eigen::VectorXd o = offsets_of(c, axis);
        cost += o.dot(drift_.matrix * o);
      }
    return cost / 2;
  }

  // Tukey's rho in units of the scale, summed. An active ray that would miss the stem costs as an outlier. Keeps the
  // values, which are those of the next step where this one is taken.
  double cost_of(const TaperedCylinder& c, double scale) {
    constexpr double k2 = 4.685 * 4.685;
    double sum = 0;
    evaluate(c, tried_);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (const auto& e = tried_[i]; share_[i] > 0)
        sum += share_[i] * rho(e.usable ? square(e.value) / (scale * scale * k2) : 1);
    return information_ * sum * k2 / 6 + prior_cost(c);
  }

  Eigen::VectorXd offsets_of(const TaperedCylinder& c, int axis) const {
    Eigen::VectorXd o(static_cast<Eigen::Index>(views_));
    for (std::size_t k = 0; k < views_; ++k) o[static_cast<Eigen::Index>(k)] = c.view_offset[k][axis];
    return o;
  }

  void add_prior(const TaperedCylinder& c, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient) const {
    const double wt = 1 / square(options_.taper_sd), wr = 1 / square(options_.range_offset.sd_m);
    normal(5, 5) += wt, gradient[5] += wt * (c.taper - options_.taper_mean);
    normal(6, 6) += wr, gradient[6] += wr * (c.range_offset - options_.range_offset.mean_m);
    if (views_ < 2) return;
    const auto n = static_cast<Eigen::Index>(views_);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::VectorXd pull = drift_.matrix * offsets_of(c, axis);
      for (Eigen::Index a = 0; a < n; ++a) {
        gradient[7 + 2 * a + axis] += pull[a];
        for (Eigen::Index b = 0; b < n; ++b) normal(7 + 2 * a + axis, 7 + 2 * b + axis) += drift_.matrix(a, b);
      }
    }
  }

  // Adds what one view says: derivatives by its offset are those by (x, y).
  void add(const Matrix7& of_view, int view, Eigen::MatrixXd& normal) const {
    normal.topLeftCorner<7, 7>() += of_view;
    if (views_ < 2) return;
    const Eigen::Index at = 7 + 2 * view;
    normal.block<2, 7>(at, 0) += of_view.topRows<2>(), normal.block<7, 2>(0, at) += of_view.leftCols<2>();
    normal.block<2, 2>(at, at) += of_view.topLeftCorner<2, 2>();
  }
  void add(const Vector7& of_view, int view, Eigen::VectorXd& gradient) const {
    gradient.head<7>() += of_view;
    if (views_ > 1) gradient.segment<2>(7 + 2 * view) += of_view.head<2>();
  }

  // At the cylinder that was evaluated last.
  double assemble(const TaperedCylinder& c, double scale, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient) const {
    const auto n = static_cast<Eigen::Index>(size_);
    normal = Eigen::MatrixXd::Zero(n, n), gradient = Eigen::VectorXd::Zero(n);
    // Small blocks per view: the offsets of two views never meet in one point.
    std::vector<Matrix8> by_view(views_, Matrix8::Zero());  // and in the last column the right-hand side
    constexpr double k2 = 4.685 * 4.685;
    double sum = 0;
    const double factor = information_ / (scale * scale);
    const CylinderResiduals of(c);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (share_[i] <= 0) continue;
      const double u2 = values_[i].usable ? square(values_[i].value) / (scale * scale * k2) : 1;
      sum += share_[i] * rho(u2);
      if (u2 >= 1) continue;
      const auto& p = points_[i];
      const auto e = residual(of, p, true);
      const double w = share_[i] * factor * (1 - u2) * (1 - u2);
      const auto k = static_cast<std::size_t>(p.view);
      Vector8 with_value;
      with_value << e.jacobian, e.value;
      for (int column = 0; column < 8; ++column) by_view[k].col(column) += w * with_value[column] * with_value;
    }
    for (std::size_t k = 0; k < views_; ++k) {
      add(Matrix7(by_view[k].topLeftCorner<7, 7>()), static_cast<int>(k), normal);
      add(Vector7(by_view[k].col(7).head<7>()), static_cast<int>(k), gradient);
    }
    add_prior(c, normal, gradient);
    return information_ * sum * k2 / 6 + prior_cost(c);
  }

  TaperedCylinder moved_by(TaperedCylinder c, const Eigen::VectorXd& step) const {
    c.x += step[0], c.y += step[1], c.slope_x += step[2], c.slope_y += step[3], c.radius += step[4], c.taper += step[5];
    c.range_offset += step[6];
    if (views_ > 1)
      for (std::size_t k = 0; k < views_; ++k)
        c.view_offset[k] += step.segment<2>(static_cast<Eigen::Index>(7 + 2 * k));
    return c;
  }

  double robust_scale(double scale) {
    std::vector<double> errors;
    errors.reserve(values_.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (const auto& e = values_[i]; share_[i] >= 0.5 && e.usable && std::abs(e.value) < 4.685 * scale)
        errors.push_back(std::abs(e.value));
    middle_error_ = upper_median_near(errors, middle_error_);
    return 1.4826 * middle_error_;
  }

  const std::vector<BarkPoint>& points_;
  const CylinderFitOptions& options_;
  std::vector<double> share_;          // by point: how much it takes part
  std::vector<Value> values_, tried_;  // at the present cylinder; at the last one tried
  std::vector<int> pass_of_view_;
  std::size_t views_;
  std::size_t size_;
  DriftPrecision drift_;
  double information_;
  double middle_error_ = 0;  // when last looked at
};

DriftEvidence JointFit::drift_evidence(const TaperedCylinder& c, const Eigen::MatrixXd& normal) const {
  const auto m = static_cast<Eigen::Index>(2 * views_);
  Eigen::MatrixXd base = normal.topLeftCorner(7, 7);
  base(5, 5) += 1 / square(options_.taper_sd), base(6, 6) += 1 / square(options_.range_offset.sd_m);
  base.diagonal() *= 1 + 1e-9;
  const Eigen::MatrixXd mixed = normal.block(0, 7, 7, m);
  DriftEvidence out;
  out.pass_of_view = pass_of_view_;
  out.information = normal.bottomRightCorner(m, m) - mixed.transpose() * base.ldlt().solve(mixed);
  Eigen::VectorXd offset(m);
  for (int axis = 0; axis < 2; ++axis)
    offset(Eigen::seqN(axis, static_cast<Eigen::Index>(views_), 2)) = offsets_of(c, axis);
  // At the optimum the prior and the data balance.
  out.target = out.information * offset;
  for (int axis = 0; axis < 2; ++axis)
    out.target(Eigen::seqN(axis, static_cast<Eigen::Index>(views_), 2)) += drift_.matrix * offsets_of(c, axis);
  return out;
}

// Covariance by the block sandwich: H^-1 (sum over blocks of g g^T) H^-1, where residuals within a block may be
// correlated at will. Two ways to block are tried, by pass and section and by pass and bearing (bark, section shape),
// and the larger variance is kept.
void JointFit::describe(CylinderFit& fit) const {
  const auto& c = fit.cylinder;
  const auto n = static_cast<Eigen::Index>(size_);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(n), by_beam = unused;
  StretchSums stretch(n);
  std::map<std::pair<int, int>, Eigen::VectorXd> by_section, by_bearing;
  fit.weight.assign(points_.size(), 0);
  const double s2 = fit.sigma_m * fit.sigma_m;
  const CylinderResiduals of(c);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (share_[i] <= 0) continue;
    const auto& p = points_[i];
    const auto e = residual(of, p, true);
    const double u = e.value / (4.685 * fit.sigma_m);
    if (!e.usable || std::abs(u) >= 1) continue;
    const double w = share_[i] * (1 - u * u) * (1 - u * u);
    fit.weight[i] = w, ++fit.inliers;
    const double curvature = information_ * share_[i] * (1 - u * u) * (1 - 5 * u * u) / s2;
    add(curvature * e.jacobian * e.jacobian.transpose(), p.view, normal);
    const double pull = information_ * w * e.value / s2, beam_pull = information_ * w * e.by_beam * p.beam_doubt / s2;
    const Vector7 g = pull * e.jacobian;
    add(beam_pull * e.jacobian, p.view, by_beam);
    const double by_stretch = p.range * (p.ray.x() * e.jacobian[0] + p.ray.y() * e.jacobian[1]);
    add(curvature * by_stretch * e.jacobian, p.view, stretch.cross);
    stretch.curvature += curvature * by_stretch * by_stretch, stretch.by_beam += beam_pull * by_stretch;
    const auto bearing =
        static_cast<int>(std::floor(std::atan2(p.p.y() - c.y, p.p.x() - c.x) / (std::numbers::pi / 6)));
    auto& a = by_section.try_emplace({p.pass, p.section}, Eigen::VectorXd::Zero(n)).first->second;
    auto& b = by_bearing.try_emplace({p.pass, bearing}, Eigen::VectorXd::Zero(n)).first->second;
    add(g, p.view, a), add(g, p.view, b);
    stretch.pull[{p.pass, bearing}] += pull * by_stretch;
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
  // Few residuals scatter by chance less than their noise allows: what the noise alone leaves unknown is the least.
  fit.radius_sd_m = std::sqrt(std::max({0.0, worse(4, 4), inverse(4, 4)}));
  fit.beam_doubt_m = std::abs(inverse.row(4).dot(by_beam));
  fit.position_sd_m = std::sqrt(std::max({0.0, worse(0, 0), worse(1, 1)}));
  if (options_.along_rays) {
    // What the prior of the offset has added to the estimate is taken out again.
    const double posterior = worse(6, 6), prior_variance = square(options_.range_offset.sd_m);
    if (posterior < 0.9 * prior_variance) {
      const double variance = 1 / (1 / posterior - 1 / prior_variance);
      fit.range_offset.sd_m = std::sqrt(variance);
      fit.range_offset.beam_doubt_m = variance / posterior * std::abs(inverse.row(6).dot(by_beam));
      fit.range_offset.value_m =
          variance * (c.range_offset / posterior - options_.range_offset.mean_m / prior_variance);
    }
    fit.radius_by_stretch_m = -inverse.row(4).dot(stretch.cross);
    fit.range_stretch = stretch.evidence(normal + prior, c.range_offset, by_bearing, by_beam);
  }
  if (views_ < 2) return;
  fit.drift = drift_evidence(c, normal);
  Eigen::VectorXd offsets(static_cast<Eigen::Index>(2 * views_));
  for (std::size_t k = 0; k < views_; ++k) offsets.segment<2>(static_cast<Eigen::Index>(2 * k)) = c.view_offset[k];
  fit.pass_offset = means_by_pass(pass_of_view_, offsets);
}

}  // namespace

namespace {

// Inverse covariance of the offsets, x and y by view, under the data and a prior.
Eigen::MatrixXd with_prior(const DriftEvidence& evidence, const DriftPrecision& drift) {
  const auto views = drift.matrix.rows();
  Eigen::MatrixXd posterior = evidence.information;
  for (int axis = 0; axis < 2; ++axis)
    posterior(Eigen::seqN(axis, views, 2), Eigen::seqN(axis, views, 2)) += drift.matrix;
  return posterior;
}

}  // namespace

double drift_log_likelihood(const DriftEvidence& evidence, const DriftPrior& prior) {
  const DriftPrecision drift(evidence.pass_of_view, prior);
  const Eigen::LDLT<Eigen::MatrixXd> solver(with_prior(evidence, drift));
  return 0.5 * evidence.target.dot(solver.solve(evidence.target)) -
         0.5 * solver.vectorD().cwiseMax(1e-300).array().log().sum() + drift.log_determinant;
}

std::vector<Eigen::Vector2d> likeliest_offsets(const DriftEvidence& evidence, const DriftPrior& prior) {
  const DriftPrecision drift(evidence.pass_of_view, prior);
  return means_by_pass(evidence.pass_of_view, with_prior(evidence, drift).ldlt().solve(evidence.target));
}

std::vector<int> number_views(std::vector<BarkPoint>& points, bool by_bearing) {
  constexpr int sectors = 18;
  using Key = std::pair<int, int>;
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (const auto& p : points)
    keys.emplace_back(
        p.pass, by_bearing ? static_cast<int>(
                                 std::floor((std::atan2(p.ray.y(), p.ray.x()) / std::numbers::pi + 1) * 0.5 * sectors))
                           : -1);
  std::map<Key, int> numbers;
  for (const auto& k : keys) numbers.emplace(k, 0);
  std::vector<int> pass_of_view;
  for (auto& [k, number] : numbers) number = static_cast<int>(pass_of_view.size()), pass_of_view.push_back(k.first);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].view = numbers[keys[i]];
  return pass_of_view;
}

std::optional<CylinderFit> fit_tapered_cylinder(const std::vector<BarkPoint>& points, TaperedCylinder start,
                                                double start_error_m, const CylinderFitOptions& options) {
  if (points.size() < 12 || !(start.radius > 0)) return std::nullopt;
  std::vector<BarkPoint> numbered = points;
  auto pass_of_view = number_views(numbered, options.along_rays);
  const std::size_t offsets = pass_of_view.size() > 1 ? pass_of_view.size() : 0;
  if (start.view_offset.size() != offsets) start.view_offset.assign(offsets, Eigen::Vector2d::Zero());
  start.range_offset = options.along_rays ? options.range_offset.mean_m : 0;
  JointFit joint(numbered, options, std::move(pass_of_view));
  CylinderFit fit;
  fit.cylinder = start, fit.along_rays = options.along_rays;
  fit.sigma_m = std::max(start_error_m / 2, options.max_sigma);
  if (!joint.solve(fit.cylinder, fit.sigma_m, fit.noise_m)) return std::nullopt;
  joint.describe(fit);
  if (fit.inliers < 12) return std::nullopt;
  return fit;
}

}  // namespace bole::stems
