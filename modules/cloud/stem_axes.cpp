#include "cloud/stem_axes.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"
#include "base/transform.h"
#include "cloud/robust_mean.h"
#include "cloud/voxels.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr double thin_cell_m = 0.05;
constexpr std::size_t max_points = 6'000'000;  // looked at when thinning
constexpr double layer_m = 0.4;
constexpr double link_cell_m = 0.10;
constexpr double widest_stem_m = 0.8;
constexpr std::size_t min_group_points = 6;
constexpr double shortest_stem_m = 2.0;
constexpr double greatest_residual_m = 0.04;
constexpr int max_missing_layers = 1;

struct Group {
  Eigen::Vector3d middle;
  int layer = 0;
};

struct Layered {
  std::uint64_t key;
  std::uint32_t point;
};

// Layers with their points' plan cells, ascending; the layer number takes the place of z in the key.
std::vector<Layered> sort_into_layers(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Layered> out;
  out.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d scaled(
        points[i].x(), points[i].y(),
        std::floor(points[i].z() / layer_m) * 2 * link_cell_m);  // layers two cells apart do not touch
    out.push_back(
        {voxel_key(scaled + Eigen::Vector3d(0, 0, 0.5 * link_cell_m), link_cell_m), static_cast<std::uint32_t>(i)});
  }
  std::sort(out.begin(), out.end(),
            [](const Layered& a, const Layered& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
  return out;
}

// Groups small enough for a stem, by layer from the lowest.
std::vector<Group> small_groups(const std::vector<Eigen::Vector3d>& points, const Run& run) {
  const auto layered = sort_into_layers(points);
  run.check_cancel();
  std::vector<std::uint64_t> keys;
  for (const auto& l : layered)
    if (keys.empty() || keys.back() != l.key) keys.push_back(l.key);
  const auto number = connected_groups(keys);
  run.check_cancel();

  struct Sums {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    std::size_t count = 0;
  };
  std::vector<Sums> sums;
  std::size_t k = 0;
  for (const auto& l : layered) {
    while (keys[k] != l.key) ++k;
    if (number[k] >= sums.size()) sums.resize(number[k] + 1);
    auto& s = sums[number[k]];
    const auto& p = points[l.point];
    s.sum += p, ++s.count;
    s.low = s.low.cwiseMin(p.head<2>()), s.high = s.high.cwiseMax(p.head<2>());
  }
  std::vector<Group> out;
  for (const auto& s : sums) {
    if (s.count < min_group_points || (s.high - s.low).maxCoeff() > widest_stem_m) continue;
    const Eigen::Vector3d middle = s.sum / static_cast<double>(s.count);
    out.push_back({middle, static_cast<int>(std::floor(middle.z() / layer_m))});
  }
  std::stable_sort(out.begin(), out.end(), [](const Group& a, const Group& b) { return a.layer < b.layer; });
  return out;
}

using Chain = std::vector<Eigen::Vector3d>;

// Where a chain should go on in a layer: straight on when it has three members, else above the last.
Eigen::Vector3d predict(const Chain& chain, double z) {
  const Eigen::Vector3d& last = chain.back();
  if (chain.size() < 3) return {last.x(), last.y(), z};
  const Eigen::Vector3d step = last - chain[chain.size() - 3];
  return last + step * ((z - last.z()) / step.z());
}

class ChainBuilder {
 public:
  explicit ChainBuilder(double max_angle_rad) : max_step_m_(std::max(0.15, layer_m * std::tan(max_angle_rad))) {}

  // `groups` of one layer.
  void add_layer(const std::vector<Group>& groups, int layer) {
    close_older_than(layer - 1 - max_missing_layers);
    std::vector<char> taken(open_.size(), 0);
    const std::size_t before = open_.size();
    for (const auto& g : groups) {
      std::size_t best = before;
      double best_distance = std::numeric_limits<double>::infinity();
      for (std::size_t c = 0; c < before; ++c) {
        if (taken[c]) continue;
        const double most = open_[c].members.size() < 3 ? max_step_m_ * (layer - open_[c].layer) : 0.15;
        const double d = (predict(open_[c].members, g.middle.z()) - g.middle).head<2>().norm();
        if (d < most && d < best_distance) best = c, best_distance = d;
      }
      if (best == before)
        open_.push_back({{g.middle}, layer});
      else
        open_[best].members.push_back(g.middle), open_[best].layer = layer, taken[best] = 1;
    }
  }

  std::vector<Chain> finish() {
    close_older_than(std::numeric_limits<int>::max());
    return std::move(closed_);
  }

 private:
  struct Open {
    Chain members;
    int layer;
  };
  void close_older_than(int layer) {
    std::vector<Open> still;
    for (auto& o : open_) {
      if (o.layer >= layer)
        still.push_back(std::move(o));
      else if (o.members.back().z() - o.members.front().z() >= shortest_stem_m)
        closed_.push_back(std::move(o.members));
    }
    open_ = std::move(still);
  }

  double max_step_m_;
  std::vector<Open> open_;
  std::vector<Chain> closed_;
};

// The line through the chain's members, after those that lie off it (branch whorls, other stems) are dropped.
StemAxis fit_axis(Chain chain) {
  StemAxis axis;
  for (int round = 0; round < 3; ++round) {
    axis.middle.setZero();
    for (const auto& p : chain) axis.middle += p;
    axis.middle /= static_cast<double>(chain.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& p : chain) scatter += (p - axis.middle) * (p - axis.middle).transpose();
    axis.direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
    if (axis.direction.z() < 0) axis.direction = -axis.direction;
    std::vector<double> off;
    for (const auto& p : chain) off.push_back((p - axis.middle).cross(axis.direction).norm());
    double squares = 0;
    for (const double d : off) squares += d * d;
    axis.residual_m = std::sqrt(squares / static_cast<double>(off.size()));
    axis.length_m = chain.back().z() - chain.front().z();
    const double most = std::max(0.03, 3 * upper_median(std::vector(off)));
    Chain kept;
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (off[i] <= most) kept.push_back(chain[i]);
    if (kept.size() == chain.size() || kept.size() < 4) break;
    chain = std::move(kept);
  }
  return axis;
}

}  // namespace

std::vector<Eigen::Vector3d> thinned(const PointCloud& cloud, const Run& run) {
  const std::size_t stride = (cloud.size() + max_points - 1) / max_points;
  struct Entry {
    std::uint64_t key;
    std::uint32_t point;
  };
  std::vector<Entry> entries;
  entries.reserve(stride ? cloud.size() / stride + 1 : 0);
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    if (entries.size() % (1 << 20) == 0) run.check_cancel();
    if (cloud.positions()[i].allFinite())
      entries.push_back({voxel_key(cloud.positions()[i].cast<double>(), thin_cell_m), static_cast<std::uint32_t>(i)});
  }
  tbb::parallel_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
  run.check_cancel();
  std::vector<Eigen::Vector3d> out;
  for (std::size_t first = 0, last = 0; first < entries.size(); first = last) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (last = first; last < entries.size() && entries[last].key == entries[first].key; ++last)
      sum += cloud.positions()[entries[last].point].cast<double>();
    out.push_back(sum / static_cast<double>(last - first));
  }
  return out;
}

std::vector<StemAxis> find_stem_axes(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up,
                                     double max_angle_rad, const Run& run) {
  const Eigen::Matrix3d R_level_map = rotation_between(up, Eigen::Vector3d::UnitZ());
  std::vector<Eigen::Vector3d> levelled;
  levelled.reserve(points.size());
  for (const auto& p : points) levelled.push_back(R_level_map * p);
  run.check_cancel();
  const auto groups = small_groups(levelled, run);
  ChainBuilder builder(max_angle_rad);
  for (std::size_t first = 0, last = 0; first < groups.size(); first = last) {
    run.check_cancel();
    for (last = first; last < groups.size() && groups[last].layer == groups[first].layer;) ++last;
    builder.add_layer(
        {groups.begin() + static_cast<std::ptrdiff_t>(first), groups.begin() + static_cast<std::ptrdiff_t>(last)},
        groups[first].layer);
  }
  std::vector<StemAxis> out;
  for (auto& chain : builder.finish()) {
    if (chain.size() < 4) continue;
    auto axis = fit_axis(std::move(chain));
    if (axis.residual_m > greatest_residual_m || axis.length_m < shortest_stem_m ||
        std::acos(std::min(1.0, axis.direction.z())) > max_angle_rad)
      continue;
    axis.direction = R_level_map.transpose() * axis.direction;
    axis.middle = R_level_map.transpose() * axis.middle;
    out.push_back(axis);
  }
  return out;
}

}  // namespace cloud
}  // namespace bole
