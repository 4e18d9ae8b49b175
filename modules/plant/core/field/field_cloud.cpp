#include "plant/core/field/field_cloud.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "plant/core/surface/depth_maps.h"
#include "plant/core/training/train_step.h"

namespace bole::plant {
namespace {

// Rays stop where they leave the region: nothing outside is wanted.
DepthMap depth_map(const FieldModel& model, const FieldView& view, const PixelWindow& window) {
  DepthMap map;
  map.camera = view.camera;
  map.directions = view.directions;
  map.color = &view.color;
  Pose T_field_camera = view.T_world_camera;
  T_field_camera.translation() -= model.space->origin;
  map.T_local_camera = T_field_camera.cast<float>();
  map.T_camera_local = T_field_camera.inverse().cast<float>();
  map.depth = DepthImage(view.camera.width, view.camera.height);
  const auto& box = model.space->boxes.front();
  tbb::parallel_for(window.y0, window.y1, [&](int y) {
    RayChunk chunk;
    for (int x = window.x0; x < window.x1; ++x) {
      const Eigen::Vector3f d(view.directions->at(x, y, 0), view.directions->at(x, y, 1), 1);
      ChunkRay ray;
      const float length = d.norm();
      ray.z_per_t = 1 / length;
      ray.footprint = static_cast<float>(1 / std::abs(view.camera.fx));
      ray.march = model.space->ray(map.T_local_camera.translation(), map.T_local_camera.linear() * (d / length), 0.5F);
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
  return cloud_of_depth_maps(maps, field.model.space->origin,
                             {options.cloud_tolerance, options.cloud_min_views, options.cloud_spacing},
                             run.part(0.8, 1), report);
}

}  // namespace bole::plant
