#include "plant/core/traits/stem_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace bole::plant {
namespace {

struct StemLayer {
  double z = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius = 0;
  double count = 0;
};

// Middle of the points of a layer near a place: the median, then the mean of those near it, which leaves pull less.
std::optional<StemLayer> layer_near(const Points3& points, const Eigen::Vector2d& place, double max_radius) {
  Eigen::Vector2d middle = place;
  StemLayer out;
  for (int round = 0; round < 5; ++round) {
    const double reach = round == 0 ? 1.5 * max_radius : max_radius;
    std::vector<double> x, y, r;
    for (const auto& p : points)
      if ((p.head<2>() - middle).norm() < reach) {
        x.push_back(p.x());
        y.push_back(p.y());
      }
    if (x.size() < 3) return std::nullopt;
    // The middle of the extent: a surface seen denser from one side pulls a mean to that side.
    std::ranges::sort(x);
    std::ranges::sort(y);
    const auto cut = static_cast<std::size_t>(0.05 * static_cast<double>(x.size()));
    const Eigen::Vector2d extent((x[cut] + x[x.size() - 1 - cut]) / 2, (y[cut] + y[y.size() - 1 - cut]) / 2);
    middle = 0.5 * (extent + Eigen::Vector2d(median(x), median(y)));
    out.count = static_cast<double>(x.size());
  }
  std::vector<double> r;
  double z = 0;
  for (const auto& p : points)
    if (const double d = (p.head<2>() - middle).norm(); d < max_radius) {
      r.push_back(d);
      z += p.z();
    }
  if (r.size() < 3) return std::nullopt;
  out.z = z / static_cast<double>(r.size());
  out.radius = median(std::move(r));
  out.middle = middle;
  return out;
}

}  // namespace

std::optional<CloudStem> stem_from_cloud(const Points3& plant, double height, double reach, double step,
                                         double max_radius) {
  const double top = height + 1.5 * reach;
  const int count = std::max(1, static_cast<int>(top / step));
  std::vector<Points3> slices(static_cast<std::size_t>(count));
  for (const auto& p : plant)
    if (p.z() >= 0 && p.z() < count * step) slices[static_cast<std::size_t>(p.z() / step)].push_back(p);
  std::vector<StemLayer> layers;
  Eigen::Vector2d place = Eigen::Vector2d::Zero(), slope = Eigen::Vector2d::Zero();
  double last_z = 0;
  for (const auto& slice : slices) {
    if (slice.empty()) continue;
    const double z = slice.front().z();
    const auto layer = layer_near(slice, place + (z - last_z) * slope, max_radius);
    if (!layer) continue;
    layers.push_back(*layer);
    // Direction over the last layers, with a lean of more than 45 degrees refused.
    if (layers.size() >= 4) {
      const auto& before = layers[layers.size() - 4];
      slope = (layer->middle - before.middle) / std::max(layer->z - before.z, step);
      if (slope.norm() > 1) slope.normalize();
    }
    place = layer->middle;
    last_z = layer->z;
  }
  std::erase_if(layers, [&](const auto& l) { return std::abs(l.z - height) > reach; });
  if (layers.size() < 5) return std::nullopt;
  CloudStem out;
  out.curve.height = height;
  out.curve.unit = reach;
  std::vector<double> weights(layers.size(), 1);
  for (int round = 0; round < 12; ++round) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> b = Eigen::Matrix<double, 3, 2>::Zero();
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const double t = (layers[i].z - height) / reach;
      const Eigen::Vector3d row(1, t, t * t);
      a += weights[i] * row * row.transpose();
      b += weights[i] * row * layers[i].middle.transpose();
    }
    a(2, 2) += 0.02 * a(0, 0);  // stems are nearly straight over a few centimetres
    a(1, 1) += 1e-6 * a(0, 0);
    const Eigen::Matrix<double, 3, 2> x = a.ldlt().solve(b);
    out.curve.place = x.row(0).transpose();
    out.curve.lean = x.row(1).transpose();
    out.curve.bow = x.row(2).transpose();
    std::vector<double> off;
    for (const auto& l : layers) off.push_back((l.middle - out.curve.at(l.z).head<2>()).norm());
    const double scale = std::max(median(off) * 1.2, 0.02 * max_radius);
    out.residual = median(off);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const double u = off[i] / (4 * scale);
      weights[i] = u < 1 ? (1 - u * u) * (1 - u * u) : 0;
    }
  }
  std::vector<double> radii, spread;
  out.min_z = layers.front().z;
  out.max_z = layers.back().z;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (weights[i] > 0.1) radii.push_back(layers[i].radius);
  if (radii.size() < 3) return std::nullopt;
  out.radius = median(radii);
  for (const double r : radii) spread.push_back(std::abs(r - out.radius));
  out.radius_sd = 1.4826 * median(std::move(spread));
  out.layers = radii.size();
  return out;
}

}  // namespace bole::plant
