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

struct Shape {
  double left, right, spread;  // spread: with the pixel

  Shape(double l, double r, double sigma) : left(l), right(r), spread(std::sqrt(sigma * sigma + pixel_variance)) {}

  Basis basis(double x) const {
    const double a = step((x - left) / spread), b = step((x - right) / spread);
    const double inside = a - b, u = (2 * x - left - right) / std::max(right - left, 1e-6);
    Basis out;
    out << 1 - a, (1 - a) * (x - left) / slope_length, inside, inside * u, inside * u * u, b,
        b * (x - right) / slope_length;
    return out;
  }
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

// Derivatives of the picture by left, right and spread where the colours stay.
Eigen::Matrix3d derivatives(double x, const Shape& s, const Colours& c) {
  const double u = (2 * x - s.left - s.right) / std::max(s.right - s.left, 1e-6);
  const double dl = (x - s.left) / s.spread, dr = (x - s.right) / s.spread;
  const Eigen::RowVector3d strip = c.row(2) + u * c.row(3) + u * u * c.row(4);
  const Eigen::RowVector3d at_left = strip - c.row(0) - (x - s.left) / slope_length * c.row(1);
  const Eigen::RowVector3d at_right = c.row(5) + (x - s.right) / slope_length * c.row(6) - strip;
  Eigen::Matrix3d out;
  out.row(0) = -bell(dl) / s.spread * at_left;
  out.row(1) = -bell(dr) / s.spread * at_right;
  out.row(2) = -(dl * bell(dl) * at_left + dr * bell(dr) * at_right) / s.spread;
  return out;
}

struct Steps {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

Steps steps_of(std::span<const StripPixel> pixels, const Shape& shape, const Linear& linear,
               const std::vector<Basis>& rows) {
  // The part of the derivatives that a change of the colours would make is taken out (Kaufman 1975).
  std::vector<Eigen::Matrix3d> j(pixels.size());
  std::array<Colours, 3> moments{Colours::Zero(), Colours::Zero(), Colours::Zero()};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    j[i] = derivatives(pixels[i].across, shape, linear.colours);
    for (int k = 0; k < 3; ++k) moments[static_cast<std::size_t>(k)] += rows[i] * j[i].row(k);
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

constexpr double min_width = 1.2, min_sigma = 0.15, max_sigma = 4;

bool possible(double left, double right, double sigma) {
  return right - left >= min_width && sigma >= min_sigma && sigma <= max_sigma;
}

}  // namespace

double strip_cost(std::span<const StripPixel> pixels, double left, double right, double sigma) {
  std::vector<Basis> rows;
  return solve(pixels, Shape(left, right, sigma), rows).squares / (3.0 * static_cast<double>(pixels.size()));
}

std::optional<StripEdges> fit_strip(std::span<const StripPixel> pixels, const StripStart& start,
                                    std::vector<std::array<double, 3>>* explained) {
  const auto inside =
      std::ranges::count_if(pixels, [&](const auto& p) { return p.across > start.left && p.across < start.right; });
  const auto before = std::ranges::count_if(pixels, [&](const auto& p) { return p.across < start.left - 1; });
  const auto behind = std::ranges::count_if(pixels, [&](const auto& p) { return p.across > start.right + 1; });
  if (inside < 2 || before < 3 || behind < 3 || pixels.size() < 12) return std::nullopt;
  double left = start.left, right = start.right, sigma = start.sigma, damping = 1e-3;
  std::vector<Basis> rows;
  Shape shape(left, right, sigma);
  Linear linear = solve(pixels, shape, rows);
  for (int round = 0; round < 25; ++round) {
    Steps s = steps_of(pixels, shape, linear, rows);
    if (!start.fit_sigma) {
      s.normal.row(2).setZero();
      s.normal.col(2).setZero();
      s.normal(2, 2) = 1;
      s.gradient[2] = 0;
    }
    Eigen::Matrix3d a = s.normal;
    a.diagonal() *= 1 + damping;
    a.diagonal().array() += 1e-12 * (s.normal.trace() + 1e-12);
    const Eigen::Vector3d d = a.ldlt().solve(s.gradient).cwiseMax(-1.0).cwiseMin(1.0);
    if (!d.allFinite()) return std::nullopt;
    const double spread = std::max(shape.spread + d[2], std::sqrt(pixel_variance + min_sigma * min_sigma));
    const double next_sigma = std::clamp(std::sqrt(spread * spread - pixel_variance), min_sigma, max_sigma);
    if (!possible(left + d[0], right + d[1], next_sigma)) {
      damping *= 10;
      if (damping > 1e6) return std::nullopt;
      continue;
    }
    const Shape moved(left + d[0], right + d[1], next_sigma);
    std::vector<Basis> moved_rows;
    Linear better = solve(pixels, moved, moved_rows);
    if (better.squares > linear.squares) {
      damping *= 10;
      if (damping > 1e6) break;
      continue;
    }
    left += d[0];
    right += d[1];
    sigma = next_sigma;
    shape = moved;
    linear = std::move(better);
    rows = std::move(moved_rows);
    damping = std::max(damping / 5, 1e-9);
    if (d.norm() < 1e-4) break;
  }
  StripEdges out;
  out.left = left;
  out.right = right;
  out.sigma = sigma;
  const double freedom = std::max(3.0 * (static_cast<double>(pixels.size()) - parts) - 3, 3.0);
  const double variance = linear.squares / freedom;
  out.residual = std::sqrt(variance);
  Steps s = steps_of(pixels, shape, linear, rows);
  if (!start.fit_sigma) {
    s.normal.row(2).setZero();
    s.normal.col(2).setZero();
    s.normal(2, 2) = 1;
  }
  s.normal.diagonal().array() += 1e-12 * (s.normal.trace() + 1e-12);
  const Eigen::Matrix3d covariance = s.normal.inverse() * variance;
  out.sd_left = std::sqrt(std::max(covariance(0, 0), 0.0));
  out.sd_right = std::sqrt(std::max(covariance(1, 1), 0.0));
  const auto& c = linear.colours;
  const Eigen::RowVector3d left_step = c.row(2) - c.row(3) + c.row(4) - c.row(0);
  const Eigen::RowVector3d right_step = c.row(2) + c.row(3) + c.row(4) - c.row(5);
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
