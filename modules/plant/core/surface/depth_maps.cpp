#include "plant/core/surface/depth_maps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace bole::plant {
namespace {

struct CloudPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(), color = Eigen::Vector3f::Zero();
  std::int32_t views = 0;
  std::uint64_t key = 0;
};

Eigen::Vector3f point_in_camera(const DepthMap& map, int x, int y) {
  const float z = map.depth.at(x, y);
  return {map.directions->at(x, y, 0) * z, map.directions->at(x, y, 1) * z, z};
}

// From the neighbours that lie on the same surface; zero where there are none.
Eigen::Vector3f normal_at(const DepthMap& map, int x, int y, float tolerance) {
  const Eigen::Vector3f middle = point_in_camera(map, x, y);
  const auto along = [&](int dx, int dy) -> Eigen::Vector3f {
    Eigen::Vector3f low = middle, high = middle;
    const auto take = [&](int u, int v, Eigen::Vector3f& end) {
      if (map.depth.contains(u, v) && map.depth.at(u, v) > 0 && std::abs(map.depth.at(u, v) - middle.z()) < tolerance)
        end = point_in_camera(map, u, v);
    };
    take(x - dx, y - dy, low);
    take(x + dx, y + dy, high);
    return high - low;
  };
  Eigen::Vector3f normal = along(0, 2).cross(along(2, 0));
  const float length = normal.norm();
  if (!(length > 0)) return Eigen::Vector3f::Zero();
  normal /= length;
  return normal.dot(middle) > 0 ? Eigen::Vector3f(-normal) : normal;
}

// The views to compare a view with: the nearest, because those see the same side.
std::vector<std::size_t> partners_of(const std::vector<DepthMap>& maps, std::size_t own) {
  constexpr std::size_t max_partners = 24;
  std::vector<std::pair<float, std::size_t>> order;
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (i != own)
      order.emplace_back((maps[i].T_local_camera.translation() - maps[own].T_local_camera.translation()).norm(), i);
  std::ranges::sort(order);
  std::vector<std::size_t> partners;
  for (std::size_t k = 0; k < order.size() && k < max_partners; ++k) partners.push_back(order[k].second);
  return partners;
}

// How many views, itself counted, have the point at their median depth; -1 where the point floats in front of many.
int agreeing_views(const std::vector<DepthMap>& maps, const std::vector<std::size_t>& partners,
                   const Eigen::Vector3f& p, float tolerance) {
  int agree = 1, contradict = 0;
  for (const auto i : partners) {
    const Eigen::Vector3f q = maps[i].T_camera_local * p;
    if (q.z() < 0.01F) continue;
    const auto& camera = maps[i].camera;
    float u = static_cast<float>(camera.fx) * q.x() / q.z() + static_cast<float>(camera.cx);
    float v = static_cast<float>(camera.fy) * q.y() / q.z() + static_cast<float>(camera.cy);
    if (camera.distorted()) {
      const auto pixel = camera.project(q.cast<double>());
      if (!pixel) continue;
      u = static_cast<float>(pixel->x());
      v = static_cast<float>(pixel->y());
    }
    if (!(u > -0.5F && v > -0.5F && u < 1e5F && v < 1e5F)) continue;
    const int x = static_cast<int>(std::lround(u)), y = static_cast<int>(std::lround(v));
    if (!maps[i].depth.contains(x, y)) continue;
    const float z = maps[i].depth.at(x, y);
    if (z <= 0) continue;
    if (std::abs(z - q.z()) < tolerance) ++agree;
    if (z > q.z() + 4 * tolerance) ++contradict;
  }
  return contradict > 2 * agree ? -1 : agree;
}

std::uint64_t cube_key(const Eigen::Vector3f& p, double spacing) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k)
    key = key << 21 |
          (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p(k) / spacing)) + (1 << 20)) & 0x1FFFFF);
  return key;
}

// Sums of the points of one cube.
struct CubeSum {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(), color = Eigen::Vector3f::Zero();
  std::int32_t points = 0, views = 0;
};

// One point per cube. Both sides of a thin leaf may meet in one cube: the first point decides the side of its normal.
class ThinnedCloud {
 public:
  explicit ThinnedCloud(bool thin) : thin_(thin) {}

  void add(const CloudPoint& p) {
    std::size_t index = sums_.size();
    if (thin_) index = cubes_.try_emplace(p.key, static_cast<std::uint32_t>(sums_.size())).first->second;
    if (index == sums_.size()) sums_.emplace_back();
    auto& sum = sums_[index];
    sum.position += p.position;
    if (sum.normal.dot(p.normal) >= 0) sum.normal += p.normal;
    sum.color += p.color;
    ++sum.points;
    sum.views = std::max(sum.views, p.views);
  }
  PointCloud cloud(const Eigen::Vector3d& origin) const;

 private:
  bool thin_;
  std::unordered_map<std::uint64_t, std::uint32_t> cubes_;
  std::vector<CubeSum> sums_;
};

PointCloud ThinnedCloud::cloud(const Eigen::Vector3d& origin) const {
  PointCloud::Positions positions;
  std::array<std::vector<float>, 3> normals;
  std::array<std::vector<std::uint16_t>, 3> colors;
  std::vector<std::int32_t> views;
  for (const auto& sum : sums_) {
    const auto n = static_cast<float>(sum.points);
    positions.push_back(sum.position / n);
    const float length = sum.normal.norm();
    for (int k = 0; k < 3; ++k) {
      normals[static_cast<std::size_t>(k)].push_back(length > 0 ? sum.normal(k) / length : 0.0F);
      colors[static_cast<std::size_t>(k)].push_back(
          static_cast<std::uint16_t>(std::lround(std::clamp(sum.color(k) / n, 0.0F, 255.0F) * 257)));
    }
    views.push_back(sum.views);
  }
  PointCloud cloud(std::move(positions), origin);
  cloud.set_column("normal_x", std::move(normals[0]));
  cloud.set_column("normal_y", std::move(normals[1]));
  cloud.set_column("normal_z", std::move(normals[2]));
  cloud.set_column(arrays::red, std::move(colors[0]));
  cloud.set_column(arrays::green, std::move(colors[1]));
  cloud.set_column(arrays::blue, std::move(colors[2]));
  cloud.set_column("views", std::move(views));
  return cloud;
}

}  // namespace

PointCloud cloud_of_depth_maps(const std::vector<DepthMap>& maps, const Eigen::Vector3d& origin,
                               const DepthMapOptions& options, const Run& run, Report& report) {
  const auto tolerance = static_cast<float>(options.tolerance);
  const int min_views = std::min(options.min_views, static_cast<int>(maps.size()));
  ThinnedCloud thinned(options.spacing > 0);
  std::int64_t seen = 0, kept = 0;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    run.check_cancel();
    run.report(static_cast<double>(m) / static_cast<double>(maps.size()), "comparing views");
    const auto& map = maps[m];
    const auto partners = partners_of(maps, m);
    std::vector<std::vector<CloudPoint>> rows(static_cast<std::size_t>(map.depth.height));
    tbb::parallel_for(0, map.depth.height, [&](int y) {
      for (int x = 0; x < map.depth.width; ++x) {
        if (map.depth.at(x, y) <= 0) continue;
        CloudPoint p;
        p.position = map.T_local_camera * point_in_camera(map, x, y);
        p.views = agreeing_views(maps, partners, p.position, tolerance);
        if (p.views < min_views) continue;
        p.normal = map.T_local_camera.linear() * normal_at(map, x, y, 3 * tolerance);
        for (int c = 0; c < 3; ++c) p.color(c) = map.color->at(x, y, c);
        p.key = options.spacing > 0 ? cube_key(p.position, options.spacing) : 0;
        rows[static_cast<std::size_t>(y)].push_back(p);
      }
    });
    for (const float z : map.depth.values) seen += z > 0;
    for (const auto& row : rows)
      for (const auto& p : row) {
        thinned.add(p);
        ++kept;
      }
  }
  report.counts["depths_seen"] = seen;
  report.counts["depths_kept"] = kept;
  auto cloud = thinned.cloud(origin);
  report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  return cloud;
}

std::shared_ptr<const PixelDirections> pixel_directions(const CameraModel& camera) {
  auto directions = std::make_shared<PixelDirections>(camera.width, camera.height, 2);
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d d = camera.direction({x, y});
      directions->at(x, y, 0) = static_cast<float>(d.x());
      directions->at(x, y, 1) = static_cast<float>(d.y());
    }
  return directions;
}

}  // namespace bole::plant
