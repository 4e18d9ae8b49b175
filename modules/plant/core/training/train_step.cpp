#include "plant/core/training/train_step.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace bole::plant {
namespace {

constexpr int rays_per_chunk = 256;
constexpr double region_share = 0.8;  // of the rays go through the region's part of the picture

void choose_ray(const FieldModel& field, const std::vector<FieldView>& views, const std::vector<std::size_t>& training,
                const std::vector<PixelWindow>& windows, Random random, ChunkRay& ray, TrainBatch::Target& target) {
  const auto v = training[static_cast<std::size_t>(random.index(static_cast<int>(training.size())))];
  const auto& view = views[v];
  PixelWindow window = windows[v];
  if (window.x1 <= window.x0 || window.y1 <= window.y0 || !random.chance(region_share))
    window = {0, 0, view.color.width, view.color.height};
  const int x = window.x0 + random.index(window.x1 - window.x0), y = window.y0 + random.index(window.y1 - window.y0);
  const Eigen::Vector3f d(view.directions->at(x, y, 0), view.directions->at(x, y, 1), 1);
  const float length = d.norm();
  ray.z_per_t = 1 / length;
  ray.footprint = static_cast<float>(1 / std::abs(view.camera.fx));
  ray.march =
      field.space->ray((view.T_world_camera.translation() - field.space->origin).cast<float>(),
                       view.T_world_camera.linear().cast<float>() * (d / length), static_cast<float>(random.uniform()));
  target.view = static_cast<std::int32_t>(v);
  for (int c = 0; c < 3; ++c) target.color(c) = static_cast<float>(view.color.at(x, y, c)) / 255;
  target.depth = view.depth.empty() ? 0.0F : view.depth.at(x, y);
  target.behind = field.environment.place(ray.march.direction);
}

}  // namespace

PixelWindow window_of_region(const FieldSpace& space, const FieldView& view) {
  const auto& box = space.boxes.front();
  const Eigen::Vector3f low = box.min, high = box.max();
  Eigen::Array2d first(1e9, 1e9), last(-1e9, -1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p =
        space.origin + Eigen::Vector3d(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                                       corner & 4 ? high.z() : low.z());
    const auto pixel = view.camera.project(view.T_world_camera.inverse() * p);
    if (!pixel) return {0, 0, view.camera.width, view.camera.height};  // the camera stands inside
    first = first.min(pixel->array());
    last = last.max(pixel->array());
  }
  const auto within = [](double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  return {within(first.x(), view.camera.width), within(first.y(), view.camera.height),
          within(last.x() + 1, view.camera.width), within(last.y() + 1, view.camera.height)};
}

namespace {

// Price of light that stops at `t`, where depth was measured: little near the measured depth, at most one far from it.
float depth_price(const TrainBatch::Target& target, float z_per_t, float t, const DepthNoise& noise) {
  const float off = (t * z_per_t - target.depth) / (2 * static_cast<float>(noise.sigma(target.depth)));
  return off * off / (1 + off * off);
}

// Chooses and renders the rays of a chunk.
void render_rays(const FieldModel& field, const std::vector<FieldView>& views, const std::vector<std::size_t>& training,
                 const std::vector<PixelWindow>& windows, const TrainSetting& setting, int step, std::size_t c,
                 RayChunk& chunk, std::vector<TrainBatch::Target>& targets) {
  chunk.clear();
  chunk.rays.resize(rays_per_chunk);
  targets.assign(rays_per_chunk, {});
  for (std::size_t r = 0; r < rays_per_chunk; ++r)
    choose_ray(
        field, views, training, windows,
        Random(static_cast<std::uint64_t>(setting.seed), static_cast<std::uint64_t>(step), c * rays_per_chunk + r),
        chunk.rays[r], targets[r]);
  render_chunk(*field.space, *field.encoder, chunk, 1e-3F);
  for (std::size_t r = 0; r < rays_per_chunk; ++r) {
    const auto& ray = chunk.rays[r];
    auto& target = targets[r];
    const Eigen::Array3f factor = field.exposures.factor(static_cast<std::size_t>(target.view));
    const Eigen::Vector3f behind = field.environment.color(target.behind);
    target.error = ((ray.color + ray.transmittance * behind).array() * factor).matrix() - target.color;
  }
}

// A sample moves with its camera, and about it.
void add_pose_gradients(const TrainBatch& batch, PoseRefinement& poses) {
  for (std::size_t c = 0; c < batch.chunks.size(); ++c)
    for (std::size_t i = 0; i < batch.chunks[c].samples.size(); ++i) {
      const auto& sample = batch.chunks[c].samples[i];
      const auto ray = static_cast<std::size_t>(sample.ray);
      const Eigen::Vector3f& by_position = batch.chunks[c].d_position[i];
      auto& g = poses.gradients[static_cast<std::size_t>(batch.targets[c][ray].view)];
      g.translation += by_position.cast<double>();
      g.rotation += (sample.place.t * batch.chunks[c].rays[ray].march.direction.cross(by_position)).cast<double>();
    }
}

std::size_t chunk_count(const TrainSetting& setting) {
  return static_cast<std::size_t>((setting.rays + rays_per_chunk - 1) / rays_per_chunk);
}

}  // namespace

double train_loss(const FieldModel& field, const std::vector<FieldView>& views,
                  const std::vector<std::size_t>& training, const std::vector<PixelWindow>& windows,
                  const TrainSetting& setting, int step, TrainBatch& batch) {
  const auto count = chunk_count(setting);
  batch.chunks.resize(count);
  batch.targets.resize(count);
  double sum = 0;
  for (std::size_t c = 0; c < count; ++c) {
    auto& chunk = batch.chunks[c];
    render_rays(field, views, training, windows, setting, step, c, chunk, batch.targets[c]);
    for (std::size_t r = 0; r < rays_per_chunk; ++r) {
      const auto& target = batch.targets[c][r];
      sum += target.error.squaredNorm() / 3;
      if (target.depth > 0) sum += setting.depth_weight * chunk.rays[r].transmittance;
    }
    for (const auto& sample : chunk.samples) {
      const auto& target = batch.targets[c][static_cast<std::size_t>(sample.ray)];
      if (target.depth > 0)
        sum += setting.depth_weight * sample.before * sample.alpha *
               depth_price(target, chunk.rays[static_cast<std::size_t>(sample.ray)].z_per_t, sample.place.t,
                           setting.noise);
    }
  }
  return sum / static_cast<double>(count * rays_per_chunk);
}

double train_step(FieldModel& field, const std::vector<FieldView>& views, const std::vector<std::size_t>& training,
                  const std::vector<PixelWindow>& windows, const TrainSetting& setting, int step, TrainBatch& batch) {
  const auto count = chunk_count(setting);
  batch.chunks.resize(count);
  batch.gradients.resize(count);
  batch.targets.resize(count);
  const float share = 1.0F / static_cast<float>(count * rays_per_chunk);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t c) {
    auto& chunk = batch.chunks[c];
    auto& targets = batch.targets[c];
    auto& gradients = batch.gradients[c];
    render_rays(field, views, training, windows, setting, step, c, chunk, targets);
    gradients.assign(rays_per_chunk, {});
    for (std::size_t r = 0; r < rays_per_chunk; ++r) {
      const auto& target = targets[r];
      const Eigen::Array3f factor = field.exposures.factor(static_cast<std::size_t>(target.view));
      const Eigen::Vector3f behind = field.environment.color(target.behind);
      const Eigen::Vector3f by_color = (2.0F / 3.0F * share * target.error.array() * factor).matrix();
      gradients[r].color = by_color;
      gradients[r].transmittance = by_color.dot(behind);
      // What passes the measured surface costs as much as what stops far from it.
      if (target.depth > 0) gradients[r].transmittance += setting.depth_weight * share;
    }
    differentiate_chunk(chunk, gradients, [&](std::size_t r, float t) {
      if (targets[r].depth <= 0) return 0.0F;
      return setting.depth_weight * share * depth_price(targets[r], chunk.rays[r].z_per_t, t, setting.noise);
    });
    chunk.wants_d_position = setting.poses != nullptr;
    field.encoder->backward(chunk);
  });
  field.encoder->accumulate(batch.chunks);
  if (setting.poses != nullptr) add_pose_gradients(batch, *setting.poses);
  double square = 0;
  for (std::size_t c = 0; c < count; ++c)
    for (std::size_t r = 0; r < rays_per_chunk; ++r) {
      const auto& ray = batch.chunks[c].rays[r];
      const auto& target = batch.targets[c][r];
      square += target.error.squaredNorm() / 3;
      const auto view = static_cast<std::size_t>(target.view);
      field.environment.add_gradient(target.behind, ray.transmittance * batch.gradients[c][r].color);
      if (setting.exposure)
        field.exposures.gradients[view] +=
            2.0F / 3.0F * share * target.error.array() * (target.error + target.color).array();
    }
  return square / static_cast<double>(count * rays_per_chunk);
}

}  // namespace bole::plant
