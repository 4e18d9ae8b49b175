#include "plant/core/traits/edge_profile.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bole::plant {
namespace {

constexpr int parts = 7;  // left colour and slope; strip colour, slope and curve; right colour and slope
using Basis = Eigen::Matrix<double, parts, 1>;
using Normal = Eigen::Matrix<double, parts, parts>;
using Colours = Eigen::Matrix<double, parts, 3>;

double step(double x) { return 0.5 * std::erfc(-x * std::numbers::sqrt2 / 2); }
double bell(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi); }

constexpr double pixel_variance = 1.0 / 12;
constexpr double slope_length = 6;  // pixels over which a background may change by its own contrast

// Values of the seven parts of the picture across the strip, blurred.
class Shape {
 public:
  // `rounded`: with the shading of a cylinder. Without it the strip is a plain one, which is cheaper.
  Shape(double l, double r, double sigma, bool rounded)
      : left(l),
        right(r),
        spread(std::sqrt(sigma * sigma + pixel_variance)),
        middle_((l + r) / 2),
        half_(std::max((r - l) / 2, 1e-6)) {
    if (!rounded) return;
    // Gauss and Chebyshev's quadrature of the second kind, fine enough for the point spread.
    const int n = std::clamp(static_cast<int>(std::ceil(5 * half_ / spread)), 10, 60);
    for (int k = 1; k <= n; ++k) {
      const double angle = k * std::numbers::pi / (n + 1);
      nodes_.push_back(middle_ + half_ * std::cos(angle));
      weights_.push_back(half_ * std::numbers::pi / (n + 1) * std::sin(angle) * std::sin(angle) / spread);
    }
  }

  // The light that falls on a round stem from one direction is a + b u + c sqrt(1 - u^2), u from -1 to 1 across it.
  Basis basis(double x) const {
    const double a = step((x - left) / spread), b = step((x - right) / spread);
    const double inside = a - b;
    const double slope =
        (x - middle_) / half_ * inside + spread / half_ * (bell((x - left) / spread) - bell((x - right) / spread));
    double round = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (const double d = (x - nodes_[k]) / spread; std::abs(d) < 6) round += weights_[k] * bell(d);
    Basis out;
    out << 1 - a, (1 - a) * (x - left) / slope_length, inside, slope, round, b, b * (x - right) / slope_length;
    return out;
  }

  double left, right, spread;

 private:
  double middle_, half_;
  std::vector<double> nodes_, weights_;
};

struct Linear {
  Eigen::LDLT<Normal> solver;
  Colours colours = Colours::Zero();
  double squares = 0;
};

// Colours that explain the pixels best. Slopes and curves are held by a weak prior, so that a strip whose one side is
// barely seen has a solution.
Linear solve(std::span<const StripPixel> pixels, const Shape& shape, std::vector<Basis>& rows) {
  Normal a = Normal::Zero();
  Colours b = Colours::Zero();
  rows.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    rows[i] = shape.basis(pixels[i].across);
    a.selfadjointView<Eigen::Lower>().rankUpdate(rows[i]);
    b += rows[i] * Eigen::Map<const Eigen::RowVector3d>(pixels[i].value.data());
  }
  a.triangularView<Eigen::StrictlyUpper>() = a.transpose();
  const double n = static_cast<double>(pixels.size());
  for (const int k : {1, 3, 4, 6}) a(k, k) += 2e-3 * n;
  for (const int k : {0, 2, 5}) a(k, k) += 1e-9 * n;
  Linear out;
  out.solver.compute(a);
  out.colours = out.solver.solve(b);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    out.squares += (Eigen::Map<const Eigen::RowVector3d>(pixels[i].value.data()) - rows[i].transpose() * out.colours)
                       .squaredNorm();
  return out;
}

struct Parameters {
  double left, right, sigma;
  Shape shape() const { return {left, right, sigma, true}; }
};

struct Steps {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

Steps steps_of(std::span<const StripPixel> pixels, const Parameters& at, const Linear& linear,
               const std::vector<Basis>& rows) {
  constexpr double h = 1e-3;
  const std::array<Shape, 3> moved{Parameters{at.left + h, at.right, at.sigma}.shape(),
                                   Parameters{at.left, at.right + h, at.sigma}.shape(),
                                   Parameters{at.left, at.right, at.sigma + h}.shape()};
  // The part of the derivatives that a change of the colours would make is taken out (Kaufman 1975).
  std::vector<Eigen::Matrix3d> j(pixels.size());
  std::array<Colours, 3> moments{Colours::Zero(), Colours::Zero(), Colours::Zero()};
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Basis change = (moved[static_cast<std::size_t>(k)].basis(pixels[i].across) - rows[i]) / h;
      j[i].row(k) = change.transpose() * linear.colours;
      moments[static_cast<std::size_t>(k)] += rows[i] * j[i].row(k);
    }
  std::array<Colours, 3> taken;
  for (std::size_t k = 0; k < 3; ++k) taken[k] = linear.solver.solve(moments[k]);
  Steps out;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::RowVector3d off =
        Eigen::Map<const Eigen::RowVector3d>(pixels[i].value.data()) - rows[i].transpose() * linear.colours;
    for (int k = 0; k < 3; ++k) j[i].row(k) -= rows[i].transpose() * taken[static_cast<std::size_t>(k)];
    out.normal += j[i] * j[i].transpose();
    out.gradient += j[i] * off.transpose();
  }
  return out;
}

// The spread is known: only the edges move.
void hold_sigma(Steps& steps) {
  steps.normal.row(2).setZero();
  steps.normal.col(2).setZero();
  steps.normal(2, 2) = 1;
  steps.gradient[2] = 0;
}

constexpr double min_width = 1.2, min_sigma = 0.15, max_sigma = 4;

}  // namespace

double strip_cost(std::span<const StripPixel> pixels, double left, double right, double sigma) {
  std::vector<Basis> rows;
  return solve(pixels, Shape(left, right, sigma, false), rows).squares / (3.0 * static_cast<double>(pixels.size()));
}

std::optional<StripEdges> fit_strip(std::span<const StripPixel> pixels, const StripStart& start,
                                    std::vector<std::array<double, 3>>* explained) {
  const auto inside =
      std::ranges::count_if(pixels, [&](const auto& p) { return p.across > start.left && p.across < start.right; });
  const auto before = std::ranges::count_if(pixels, [&](const auto& p) { return p.across < start.left - 1; });
  const auto behind = std::ranges::count_if(pixels, [&](const auto& p) { return p.across > start.right + 1; });
  if (inside < 2 || before < 3 || behind < 3 || pixels.size() < 12) return std::nullopt;
  Parameters at{start.left, start.right, start.sigma};
  double damping = 1e-3;
  std::vector<Basis> rows, moved_rows;
  Linear linear = solve(pixels, at.shape(), rows);
  bool moved_since = true;
  Steps s;
  for (int round = 0; round < 25 && damping < 1e6; ++round) {
    if (moved_since) s = steps_of(pixels, at, linear, rows);
    if (!start.fit_sigma) hold_sigma(s);
    moved_since = false;
    Eigen::Matrix3d a = s.normal;
    a.diagonal() *= 1 + damping;
    a.diagonal().array() += 1e-12 * (s.normal.trace() + 1e-12);
    const Eigen::Vector3d d = a.ldlt().solve(s.gradient).cwiseMax(-1.0).cwiseMin(1.0);
    if (!d.allFinite()) return std::nullopt;
    const Parameters next{at.left + d[0], at.right + d[1], std::clamp(at.sigma + d[2], min_sigma, max_sigma)};
    damping *= 10;
    if (next.right - next.left < min_width) continue;
    Linear better = solve(pixels, next.shape(), moved_rows);
    if (better.squares > linear.squares) continue;
    at = next;
    linear = std::move(better);
    std::swap(rows, moved_rows);
    moved_since = true;
    damping = std::max(damping / 50, 1e-9);
    if (d.norm() < 2e-4) break;
  }
  if (at.right - at.left < min_width) return std::nullopt;
  StripEdges out;
  out.left = at.left;
  out.right = at.right;
  out.sigma = at.sigma;
  const double freedom = std::max(3.0 * (static_cast<double>(pixels.size()) - parts) - 3, 3.0);
  const double variance = linear.squares / freedom;
  out.residual = std::sqrt(variance);
  s = steps_of(pixels, at, linear, rows);
  if (!start.fit_sigma) hold_sigma(s);
  s.normal.diagonal().array() += 1e-12 * (s.normal.trace() + 1e-12);
  const Eigen::Matrix3d covariance = s.normal.inverse() * variance;
  out.sd_left = std::sqrt(std::max(covariance(0, 0), 0.0));
  out.sd_right = std::sqrt(std::max(covariance(1, 1), 0.0));
  const auto& c = linear.colours;
  // Half way to the middle of the strip its edges have their usual colour.
  const Eigen::RowVector3d left_step = c.row(2) - 0.5 * c.row(3) + 0.87 * c.row(4) - c.row(0);
  const Eigen::RowVector3d right_step = c.row(2) + 0.5 * c.row(3) + 0.87 * c.row(4) - c.row(5);
  out.contrast = std::min(left_step.norm(), right_step.norm()) / std::sqrt(3.0);
  if (!std::isfinite(out.sd_left) || !std::isfinite(out.sd_right) || !std::isfinite(out.residual)) return std::nullopt;
  if (explained != nullptr) {
    explained->resize(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Eigen::RowVector3d v = rows[i].transpose() * c;
      (*explained)[i] = {v[0], v[1], v[2]};
    }
  }
  return out;
}

}  // namespace bole::plant
