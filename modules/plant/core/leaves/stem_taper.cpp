#include "plant/core/leaves/stem_taper.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/statistics.h"

namespace bole::plant {

StemTaper stem_taper(const AxisCurve& stem, const KnownDiameter& known, double step) {
  StemTaper out;
  std::vector<double> t, r;
  for (std::size_t i = 0; i < stem.places.size(); ++i)
    if (std::isfinite(stem.radii[i])) {
      t.push_back(stem.arc[i] / stem.length());
      r.push_back(stem.radii[i]);
    }
  if (t.size() < 10 || t.back() - t.front() < 0.5) return out;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  const auto row = [](double u) { return Eigen::Vector3d(1, u, u * u); };
  std::vector<double> weight(t.size(), 1);
  double scatter = 0;
  for (int round = 0; round < 12; ++round) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < t.size(); ++i) {
      a += weight[i] * row(t[i]) * row(t[i]).transpose();
      b += weight[i] * r[i] * row(t[i]);
    }
    a(2, 2) += 0.02 * a(0, 0);  // stems taper nearly evenly
    x = a.ldlt().solve(b);
    std::vector<double> off;
    for (std::size_t i = 0; i < t.size(); ++i) off.push_back(std::abs(r[i] - x.dot(row(t[i]))));
    scatter = std::max(1.4826 * median(off), 1e-3 * x[0]);
    // Where a petiole begins the slice is too wide, never too narrow.
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double u = (r[i] - x.dot(row(t[i]))) / scatter;
      weight[i] = 1 / (1 + std::pow(u / (u > 0 ? 1.0 : 2.5), 4));
    }
  }
  const auto cloud = [&](double along) { return x.dot(row(along / stem.length())); };
  const double at_known = cloud(known.along);
  if (!(at_known > 0)) return out;
  const int steps = std::max(4, static_cast<int>(std::ceil(stem.length() / step)));
  for (int i = 0; i <= steps; ++i) {
    const double along = stem.length() * i / steps;
    const double c = cloud(along), excess = at_known - known.value / 2;
    const double shifted = 2 * (c - excess);
    const double square = c * c - at_known * at_known + known.value * known.value / 4;
    const double blurred = square > 0 ? 2 * std::sqrt(square) : 0;
    const double value = std::max(0.0, (shifted + blurred) / 2);
    out.along.push_back(along);
    out.diameter.push_back(value);
    // Far from the known place the curve of the cloud counts, with its scatter. A field fattens the thin end of a stem
    // more than the thick one, by an amount that nothing tells: clouds have shown less than half of the taper.
    constexpr double taper_doubt = 0.25;  // of the diameter, over the whole length
    const double away = std::abs(along - known.along) / stem.length();
    const double curve_sd = 0.5 * scatter * std::min(1.0, away / 0.3);
    out.sd.push_back(
        std::hypot(std::hypot(known.sd, (shifted - blurred) / 2), std::hypot(curve_sd, taper_doubt * value * away)));
  }
  const auto volume = [&](double sds) {
    double sum = 0;
    for (std::size_t i = 1; i < out.along.size(); ++i) {
      const double a = std::max(0.0, out.diameter[i - 1] + sds * out.sd[i - 1]);
      const double b = std::max(0.0, out.diameter[i] + sds * out.sd[i]);
      sum += std::numbers::pi / 12 * (a * a + a * b + b * b) * (out.along[i] - out.along[i - 1]);
    }
    return sum;
  };
  out.volume = volume(0);
  out.volume_low = volume(-1.96);
  out.volume_high = volume(1.96);
  return out;
}

}  // namespace bole::plant
