#include "plant/core/traits/extents.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr int replicates = 16;
constexpr std::array<double, 4> added{0.5, 1, 1.5, 2};  // times the variance of the noise
constexpr int directions = 48;

// Standard deviation of the points across their surface: the smallest spread of neighbourhoods, the median of them.
double noise_of(const Points3& points, double spacing) {
  const double radius = std::max(5 * spacing, 1e-9);
  const PointGrid grid(points, radius);
  Random random(41, points.size());
  std::vector<double> sizes;
  for (int k = 0; k < 600; ++k) {
    const auto& p = points[random.next() % points.size()];
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    double n = 0;
    grid.near(p, radius, [&](std::uint32_t i, double) {
      const Eigen::Vector3d d = points[i] - p;
      mean += d;
      square += d * d.transpose();
      n += 1;
    });
    if (n < 10) continue;
    mean /= n;
    const Eigen::Matrix3d covariance = (square - n * mean * mean.transpose()) / (n - 3);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    sizes.push_back(std::sqrt(std::max(solver.eigenvalues()[0], 0.0)));
  }
  return sizes.size() < 20 ? 0 : median(std::move(sizes));
}

// Points with a fair share of the usual number of neighbours: a tip has fewer, a stray point next to none.
Points3 supported(const Points3& points, double spacing) {
  const double radius = 4 * spacing;
  const PointGrid grid(points, radius);
  std::vector<int> counts(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    grid.near(points[i], radius, [&](std::uint32_t, double) { ++counts[i]; });
  std::vector<double> sample;
  for (std::size_t i = 0; i < counts.size(); i += std::max<std::size_t>(1, counts.size() / 5000))
    sample.push_back(counts[i]);
  const double need = std::max(4.0, 0.12 * median(std::move(sample)));
  Points3 out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (counts[i] >= need) out.push_back(points[i]);
  return out;
}

// Points that can lie on the hull or at the top once noise of a few `reach` is added.
Points3 outer(const Points3& points, double reach) {
  std::vector<bool> keep(points.size(), false);
  const auto take = [&](const Eigen::Vector3d& d) {
    double high = points.front().dot(d);
    for (const auto& p : points) high = std::max(high, p.dot(d));
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].dot(d) > high - reach) keep[i] = true;
  };
  take(Eigen::Vector3d::UnitZ());
  for (int k = 0; k < directions; ++k) {
    const double turn = 2 * std::numbers::pi * k / directions;
    take({std::cos(turn), std::sin(turn), 0});
  }
  Points3 out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i]) out.push_back(points[i]);
  return out;
}

// The value without noise: a parabola in the share of variance added, through the observed value and the means of the
// replicates, at -1. Extremes of a plant are tips of few points, which grow about evenly with the variance; those of a
// wide edge grow with the standard deviation. Half the difference to that goes into the error.
Extent extrapolated(double raw, const std::array<std::vector<double>, added.size()>& by_level) {
  double scatter = 0;
  const auto at_zero = [&](bool deviation) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    const auto take = [&](double lambda, double y, double w) {
      const Eigen::Vector3d row(1, deviation ? std::sqrt(1 + lambda) : lambda, deviation ? 0 : lambda * lambda);
      a += w * row * row.transpose();
      b += w * row * y;
    };
    take(0, raw, replicates);
    for (std::size_t k = 0; k < added.size(); ++k) {
      double mean = 0, square = 0;
      for (const double v : by_level[k]) {
        mean += v / replicates;
        square += (v - raw) * (v - raw) / replicates;
      }
      take(added[k], mean, 1);
      if (k == 1) scatter = std::sqrt(std::max(square - (mean - raw) * (mean - raw), 0.0));
    }
    if (deviation) a(2, 2) += 1;
    const Eigen::Vector3d x = a.ldlt().solve(b);
    return deviation ? x[0] : x[0] - x[1] + x[2];
  };
  const double wide = at_zero(true), blunt = at_zero(false);
  Extent out;
  out.raw = raw;
  out.value = std::clamp(blunt, 0.8 * raw, std::max(raw, 0.0));
  out.sd = std::hypot(scatter, (blunt - wide) / 2);
  return out;
}

// The measured tip that is the outermost place in a direction, or null where that is a point of the cloud.
const Tip* tip_farthest_along(const Points3& points, const std::vector<Tip>& tips, const Eigen::Vector3d& direction,
                              double near) {
  const auto far = std::ranges::max_element(points, {}, [&](const Eigen::Vector3d& p) { return p.dot(direction); });
  for (const auto& t : tips)
    if (t.measured() && (t.end() - *far).norm() < near) return &t;
  return nullptr;
}

// Root mean square of what the pictures add to tips of the cloud or take from them.
double usual_move(const std::vector<Tip>& tips) {
  double square = 0, count = 0;
  for (const auto& t : tips)
    if (t.measured()) {
      square += t.move * t.move;
      count += 1;
    }
  return count > 0 ? std::sqrt(square / count) : 0;
}

}  // namespace

void take_scatter_of_rectangle(const std::vector<Eigen::Vector2d>& plan, Extents& extents) {
  constexpr double patches_across = 16;  // about a leaf's tip
  const double side_sd = std::hypot(extents.length.sd, extents.width.sd) / 2;
  const auto scatter = rectangle_scatter(plan, side_sd, extents.rectangle.length / patches_across);
  extents.length.sd = std::max(extents.length.sd, scatter.length);
  extents.width.sd = std::max(extents.width.sd, scatter.width);
}

PointSizes sizes_of(const Points3& points) {
  PointSizes out;
  if (points.empty()) return out;
  out.top = points.front().z();
  std::vector<Eigen::Vector2d> plan;
  plan.reserve(points.size());
  for (const auto& p : points) {
    out.top = std::max(out.top, p.z());
    plan.emplace_back(p.head<2>());
  }
  const auto rectangle = smallest_rectangle(plan);
  out.length = rectangle.length;
  out.width = rectangle.width;
  return out;
}

void take_tips(const Points3& plant, const std::vector<Tip>& tips, double reach, Extents& extents) {
  const auto points = with_tips(plant, tips, reach);
  const PointSizes now = sizes_of(points);
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : points) plan.emplace_back(p.head<2>());
  const auto rectangle = smallest_rectangle(plan);
  // What a side is off: the scatter of its tip in the pictures, and of how sharp it is; or the correction for noise
  // where no picture shows it, and what the cloud has lost at the tips that pictures do show.
  const double usual = usual_move(tips);
  const auto sd_of = [&](const Tip* tip, double correction) {
    if (tip != nullptr) ++extents.sides_in_pictures;
    return tip != nullptr ? std::hypot(tip->sd, reach / 20) : std::max({std::abs(correction), extents.noise, usual});
  };
  extents.sides_in_pictures = 0;
  const auto* top = tip_farthest_along(points, tips, Eigen::Vector3d::UnitZ(), reach / 4);
  if (top != nullptr) {
    extents.top.value = now.top;
    extents.top.sd = sd_of(top, 0);
  } else {
    extents.top.sd = std::max(extents.top.sd, usual);
  }
  if (!(rectangle.length > 0)) return;
  const Eigen::Vector2d first = rectangle.corners[1] - rectangle.corners[0],
                        second = rectangle.corners[2] - rectangle.corners[1];
  const bool first_is_length = first.norm() >= second.norm();
  const auto side = [&](const Eigen::Vector2d& along, double raw, Extent& extent) {
    const Eigen::Vector3d d = Eigen::Vector3d(along.x(), along.y(), 0).normalized();
    const auto *a = tip_farthest_along(points, tips, d, reach / 4),
               *b = tip_farthest_along(points, tips, -d, reach / 4);
    if (a == nullptr && b == nullptr) {
      extent.sd = std::max(extent.sd, std::sqrt(2.0) * usual);
      return;
    }
    const double correction = (extent.value - extent.raw) / 2;
    extent.value = raw + (a == nullptr ? correction : 0) + (b == nullptr ? correction : 0);
    extent.sd = std::hypot(sd_of(a, correction), sd_of(b, correction));
  };
  side(first_is_length ? first : second, rectangle.length, extents.length);
  side(first_is_length ? second : first, rectangle.width, extents.width);
  extents.rectangle = rectangle;
  take_scatter_of_rectangle(plan, extents);
}

Extents measure_extents(const Points3& plant, const Run& run) {
  Extents out;
  out.spacing = point_spacing(plant);
  if (!(out.spacing > 0)) return out;
  Points3 points = supported(plant, out.spacing);
  if (points.size() < 20) points = plant;
  out.removed = plant.size() - points.size();
  out.noise = noise_of(points, out.spacing);
  const double reach = 7 * out.noise + 4 * out.spacing;
  const Points3 near = outer(points, reach);
  const PointSizes raw = sizes_of(near);
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : near) {
    plan.emplace_back(p.head<2>());
    if (p.z() == raw.top) out.top_point = p;
  }
  out.rectangle = smallest_rectangle(plan);

  std::array<std::array<std::vector<double>, added.size()>, 3> grown;
  for (std::size_t k = 0; k < added.size(); ++k)
    for (int r = 0; r < replicates; ++r) {
      run.check_cancel();
      Random random(43, k, static_cast<std::uint64_t>(r));
      Points3 moved = near;
      const double sigma = out.noise * std::sqrt(added[k]);
      for (auto& p : moved) p += sigma * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      const PointSizes s = sizes_of(moved);
      grown[0][k].push_back(s.top);
      grown[1][k].push_back(s.length);
      grown[2][k].push_back(s.width);
    }
  // What every second point would lose: the sampling, and single points that carry an extent.
  std::array<double, 3> lost{};
  for (int r = 0; r < replicates; ++r) {
    run.check_cancel();
    Random random(47, 0, static_cast<std::uint64_t>(r));
    Points3 half;
    for (const auto& p : near)
      if (random.chance(0.5)) half.push_back(p);
    if (half.size() < 3) half = near;
    const PointSizes s = sizes_of(half);
    lost[0] += (raw.top - s.top) / replicates;
    lost[1] += std::abs(raw.length - s.length) / replicates;
    lost[2] += std::abs(raw.width - s.width) / replicates;
  }
  out.top = extrapolated(raw.top, grown[0]);
  out.length = extrapolated(raw.length, grown[1]);
  out.width = extrapolated(raw.width, grown[2]);
  out.top.sd = std::hypot(out.top.sd, lost[0]);
  out.length.sd = std::hypot(out.length.sd, lost[1]);
  out.width.sd = std::hypot(out.width.sd, lost[2]);
  take_scatter_of_rectangle(plan, out);
  return out;
}

}  // namespace bole::plant
