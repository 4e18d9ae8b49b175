#include "plant/core/field/grid_start.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace bole::plant {
namespace {

// Thin stems are edges all over, where no depth can be trusted: half of the light passes two such voxels, so that the
// pictures decide.
constexpr float undecided = -1;

struct Sum {
  float distance = 0, weight = 0, color_weight = 0, edge_distance = 0, edge_weight = 0;
  Eigen::Array3f color = Eigen::Array3f::Zero();

  // By depth that can be trusted, or by that at edges.
  float raw_density(float voxel) const {
    if (weight > 0) return std::clamp(-2 * distance / weight / voxel, -6.0F, 3.0F);
    if (edge_weight > 0) return std::clamp(-2 * edge_distance / edge_weight / voxel, -6.0F, undecided);
    return -6;
  }
};

// What one view says of a lattice point.
void add_view(const FieldView& view, const Eigen::Isometry3f& T_camera_field, const Eigen::Vector3f& p, float reach,
              const DepthNoise& noise, Sum& sum) {
  const Eigen::Vector3f q = T_camera_field * p;
  if (q.z() < 0.02F) return;
  float u = 0, v = 0;
  if (view.camera.distorted()) {
    const auto pixel = view.camera.project(q.cast<double>());
    if (!pixel) return;
    u = static_cast<float>(pixel->x());
    v = static_cast<float>(pixel->y());
  } else {
    u = static_cast<float>(view.camera.fx) * q.x() / q.z() + static_cast<float>(view.camera.cx);
    v = static_cast<float>(view.camera.fy) * q.y() / q.z() + static_cast<float>(view.camera.cy);
  }
  if (!(u >= 0 && v >= 0 && u < static_cast<float>(view.camera.width - 1) &&
        v < static_cast<float>(view.camera.height - 1)))
    return;
  const int x = static_cast<int>(std::lround(u)), y = static_cast<int>(std::lround(v));
  const bool edge = view.depth.at(x, y) < 0;
  const float z = std::abs(view.depth.at(x, y));
  if (!(z > 0)) return;
  const float distance = z - q.z();
  if (distance < -reach) return;
  const float relative = static_cast<float>(noise.sigma(0.5) / noise.sigma(z));
  const float weight = relative * relative;
  (edge ? sum.edge_distance : sum.distance) += weight * std::min(distance, reach);
  (edge ? sum.edge_weight : sum.weight) += weight;
  if (distance > reach) return;
  sum.color_weight += weight;
  for (int c = 0; c < 3; ++c) sum.color(c) += weight * static_cast<float>(view.color.at(x, y, c));
}

}  // namespace

void start_grid(GridEncoder& grid, const FieldSpace& space, const std::vector<FieldView>& views,
                const DepthNoise& noise, int max_views, const Run& run) {
  std::vector<const FieldView*> used;
  for (const auto& v : views)
    if (!v.held_out && !v.depth.empty()) used.push_back(&v);
  if (used.empty()) return;
  const std::size_t stride =
      (used.size() + static_cast<std::size_t>(max_views) - 1) / static_cast<std::size_t>(max_views);
  std::vector<std::pair<const FieldView*, Eigen::Isometry3f>> chosen;
  for (std::size_t i = 0; i < used.size(); i += stride) {
    Pose T_field_camera = used[i]->T_world_camera;
    T_field_camera.translation() -= space.origin;
    chosen.emplace_back(used[i], T_field_camera.inverse().cast<float>());
  }
  for (std::size_t b = 0; b < space.boxes.size(); ++b) {
    const auto& box = space.boxes[b];
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, box.places.size(), 16), [&](const auto& range) {
      for (std::size_t block = range.begin(); block < range.end() && !run.cancelled(); ++block)
        for (int voxel = 0; voxel < FieldBox::block_voxels; ++voxel) {
          const Eigen::Vector3i local(voxel >> 6, voxel >> 3 & 7, voxel & 7);
          const Eigen::Vector3f p =
              box.min + (box.places[block] * FieldBox::block_size + local).cast<float>() * box.voxel;
          Sum sum;
          for (const auto& [view, T_camera_field] : chosen) {
            const float z = (T_camera_field * p).z();
            const float reach = std::max(4 * box.voxel, static_cast<float>(2.5 * noise.sigma(z)));
            add_view(*view, T_camera_field, p, reach, noise, sum);
          }
          auto& value = grid.value(b, block, static_cast<std::size_t>(voxel));
          value(0) = sum.raw_density(box.voxel);
          if (sum.color_weight > 0)
            for (int c = 0; c < 3; ++c) {
              const float share = std::clamp(sum.color(c) / sum.color_weight / 255, 0.02F, 0.98F);
              value(c + 1) = std::log(share / (1 - share));
            }
        }
    });
  }
  run.check_cancel();
}

}  // namespace bole::plant
