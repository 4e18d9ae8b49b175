#include "plant/core/field/field_cloud.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "plant/core/field/train_step.h"

namespace bole::plant {
namespace {

// One view's median depths, with what is needed to look them up.
struct DepthMap {
  const FieldView* view = nullptr;
  Eigen::Isometry3f T_camera_field = Eigen::Isometry3f::Identity(), T_field_camera = Eigen::Isometry3f::Identity();
  DepthImage depth;  // along z; 0: nowhere in the region
  Image<float> normal;
};

struct CloudPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(), color = Eigen::Vector3f::Zero();
  std::int32_t views = 0;
  std::uint64_t key = 0;
};

// Rays stop where they leave the region: nothing outside is wanted.
DepthMap depth_map(const FieldModel& model, const FieldView& view, const PixelWindow& window) {
  DepthMap map;
  map.view = &view;
  Pose T_field_camera = view.T_world_camera;
  T_field_camera.translation() -= model.space->origin;
  map.T_field_camera = T_field_camera.cast<float>();
  map.T_camera_field = T_field_camera.inverse().cast<float>();
  map.depth = DepthImage(view.camera.width, view.camera.height);
  const auto& box = model.space->boxes.front();
  tbb::parallel_for(window.y0, window.y1, [&](int y) {
    RayChunk chunk;
    for (int x = window.x0; x < window.x1; ++x) {
      const Eigen::Vector3f d(view.directions->at(x, y, 0), view.directions->at(x, y, 1), 1);
      ChunkRay ray;
      const float length = d.norm();
      ray.z_per_t = 1 / length;
      ray.march = model.space->ray(map.T_field_camera.translation(), map.T_field_camera.linear() * (d / length), 0.5F);
      ray.march.end = std::min(ray.march.end, ray.march.leaves[0]);
      chunk.rays.push_back(ray);
    }
    render_chunk(*model.space, *model.encoder, chunk, 0.45F);
    for (int x = window.x0; x < window.x1; ++x) {
      const auto& ray = chunk.rays[static_cast<std::size_t>(x - window.x0)];
      if (ray.median <= 0 || ray.median < ray.march.enters[0]) continue;
      const Eigen::Vector3f p = ray.march.origin + ray.median * ray.march.direction;
      if ((p.array() >= box.min.array()).all() && (p.array() <= box.max().array()).all())
        map.depth.at(x, y) = ray.median * ray.z_per_t;
    }
  });
  return map;
}

Eigen::Vector3f point_in_camera(const DepthMap& map, int x, int y) {
  const float z = map.depth.at(x, y);
  return {map.view->directions->at(x, y, 0) * z, map.view->directions->at(x, y, 1) * z, z};
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

// How many other views have the point at their median depth; -1 where the point floats in front of many.
int agreeing_views(const std::vector<DepthMap>& maps, std::size_t own, const Eigen::Vector3f& p, float tolerance) {
  int agree = 1, contradict = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (i == own) continue;
    const Eigen::Vector3f q = maps[i].T_camera_field * p;
    if (q.z() < 0.01F) continue;
    const auto pixel = maps[i].view->camera.project(q.cast<double>());
    if (!pixel) continue;
    const int x = static_cast<int>(std::lround(pixel->x())), y = static_cast<int>(std::lround(pixel->y()));
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

PointCloud merged(std::vector<CloudPoint> points, const Eigen::Vector3d& origin, bool thin) {
  std::ranges::stable_sort(points, {}, &CloudPoint::key);
  PointCloud::Positions positions;
  std::vector<float> nx, ny, nz;
  std::vector<std::uint16_t> red, green, blue;
  std::vector<std::int32_t> views;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i + 1;
    while (thin && end < points.size() && points[end].key == points[i].key) ++end;
    Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(),
                    color = Eigen::Vector3f::Zero();
    std::int32_t most = 0;
    for (std::size_t k = i; k < end; ++k) {
      position += points[k].position;
      // Both sides of a thin leaf may meet in one cube: the first decides the side.
      normal +=
          points[k].normal.dot(points[i].normal) < 0 ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : points[k].normal;
      color += points[k].color;
      most = std::max(most, points[k].views);
    }
    const auto n = static_cast<float>(end - i);
    positions.push_back(position / n);
    if (const float length = normal.norm(); length > 0) normal /= length;
    nx.push_back(normal.x());
    ny.push_back(normal.y());
    nz.push_back(normal.z());
    const auto value = [&](float c) {
      return static_cast<std::uint16_t>(std::lround(std::clamp(c / n, 0.0F, 255.0F) * 257));
    };
    red.push_back(value(color.x()));
    green.push_back(value(color.y()));
    blue.push_back(value(color.z()));
    views.push_back(most);
    i = end;
  }
  PointCloud cloud(std::move(positions), origin);
  cloud.set_column("normal_x", std::move(nx));
  cloud.set_column("normal_y", std::move(ny));
  cloud.set_column("normal_z", std::move(nz));
  cloud.set_column(arrays::red, std::move(red));
  cloud.set_column(arrays::green, std::move(green));
  cloud.set_column(arrays::blue, std::move(blue));
  cloud.set_column("views", std::move(views));
  return cloud;
}

}  // namespace

PointCloud field_cloud(const TrainedField& field, const FieldOptions& options, const Run& run, Report& report) {
  std::vector<DepthMap> maps;
  std::size_t training = 0, done = 0;
  for (const auto& view : field.views) training += !view.held_out;
  for (const auto& view : field.views) {
    if (view.held_out) continue;
    run.check_cancel();
    run.report(0.8 * static_cast<double>(done++) / static_cast<double>(training), "rendering depth");
    maps.push_back(depth_map(field.model, view, window_of_region(*field.model.space, view)));
  }
  const auto tolerance = static_cast<float>(options.cloud_tolerance);
  const int min_views = std::min(options.cloud_min_views, static_cast<int>(maps.size()));
  std::vector<std::vector<CloudPoint>> parts(maps.size());
  std::int64_t seen = 0;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    run.check_cancel();
    run.report(0.8 + 0.2 * static_cast<double>(m) / static_cast<double>(maps.size()), "comparing views");
    const auto& map = maps[m];
    std::vector<std::vector<CloudPoint>> rows(static_cast<std::size_t>(map.depth.height));
    tbb::parallel_for(0, map.depth.height, [&](int y) {
      for (int x = 0; x < map.depth.width; ++x) {
        if (map.depth.at(x, y) <= 0) continue;
        CloudPoint p;
        p.position = map.T_field_camera * point_in_camera(map, x, y);
        p.views = agreeing_views(maps, m, p.position, tolerance);
        if (p.views < min_views) continue;
        p.normal = map.T_field_camera.linear() * normal_at(map, x, y, 3 * tolerance);
        for (int c = 0; c < 3; ++c) p.color(c) = map.view->color.at(x, y, c);
        p.key = options.cloud_spacing > 0 ? cube_key(p.position, options.cloud_spacing) : 0;
        rows[static_cast<std::size_t>(y)].push_back(p);
      }
    });
    for (const float z : map.depth.values) seen += z > 0;
    for (const auto& row : rows) parts[m].insert(parts[m].end(), row.begin(), row.end());
  }
  std::vector<CloudPoint> all;
  for (auto& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
  report.counts["depths_seen"] = seen;
  report.counts["depths_kept"] = static_cast<std::int64_t>(all.size());
  auto cloud = merged(std::move(all), field.model.space->origin, options.cloud_spacing > 0);
  report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  return cloud;
}

}  // namespace bole::plant
