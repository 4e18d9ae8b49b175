#include "stems/core/fit/seen_bark.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::stems {
namespace {

using std::numbers::pi;

struct Harmonic {
  int order;
  double amplitude;  // standard deviation, as a share of the radius
};
// Half of the stems have a widest diameter that is 3 to 4 % more than the narrowest: an assumption, as is the third
// order.
constexpr std::array<Harmonic, 2> out_of_round{{{2, 0.02}, {3, 0.01}}};
constexpr double most = 0.03;  // where less than about 150 deg were seen, which is told apart

}  // namespace

void SeenBark::add(double bearing_rad) {
  const double turns = bearing_rad / (2 * pi);
  ++points_[static_cast<std::size_t>((turns - std::floor(turns)) * count) % count];
}

double SeenBark::shape_sd() const {
  // Least squares of a circle, middle free, to a harmonic over the sectors that were seen.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2 * out_of_round.size()> moments;
  moments.setZero();
  for (std::size_t i = 0; i < count; ++i) {
    const double bearing = 2 * pi * (static_cast<double>(i) + 0.5) / count;
    const Eigen::Vector3d circle(1, std::cos(bearing), std::sin(bearing));
    normal += points_[i] * circle * circle.transpose();
    for (std::size_t k = 0; k < out_of_round.size(); ++k) {
      const auto [order, amplitude] = out_of_round[k];
      const auto column = static_cast<Eigen::Index>(2 * k);
      moments.col(column) += points_[i] * amplitude * std::cos(order * bearing) * circle;
      moments.col(column + 1) += points_[i] * amplitude * std::sin(order * bearing) * circle;
    }
  }
  if (!(normal.trace() > 0)) return most;
  normal.diagonal().array() += 1e-6 * normal.trace();
  // The phase is any: sine and cosine have half of the variance each.
  const double variance = 0.5 * normal.ldlt().solve(moments).row(0).squaredNorm();
  return std::isfinite(variance) ? std::min(most, std::sqrt(variance)) : most;
}

}  // namespace bole::stems
