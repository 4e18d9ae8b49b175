#include "plant/core/surface/tsdf.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"

namespace bole::plant {
namespace {

constexpr int size = Tsdf::block_size;

// What the voxels need of one view.
struct DepthView {
  CameraModel depth_camera, color_camera;
  Eigen::Isometry3f T_depth_world = Eigen::Isometry3f::Identity(), T_color_world = Eigen::Isometry3f::Identity();
  bool distorted = false, color_distorted = false;
  DepthImage depth, weights;
  ColorImage color;
};

void read_depth(const ViewSource& views, const PosedView& posed, bool color, const DepthNoise& noise, View& view,
                DepthView& out) {
  views.read(posed.index, view, {.color = color, .depth = true, .mask = false});
  const auto& camera = views.camera(posed.index);
  out.depth_camera = camera.of_depth();
  out.color_camera = camera.color;
  out.distorted = out.depth_camera.distorted();
  out.color_distorted = out.color_camera.distorted();
  const Pose T_world_depth = posed.T_world_camera * camera.T_color_depth;
  out.T_depth_world = T_world_depth.inverse().cast<float>();
  out.T_color_world = posed.T_world_camera.inverse().cast<float>();
  for (float& z : view.depth.values)
    if (!(z > 0) || !std::isfinite(z)) z = 0;
  std::swap(out.depth, view.depth);
  if (!color) return;
  std::swap(out.color, view.color);
  out.weights = viewing_cosines(out.depth, out.depth_camera);
  const auto edges = depth_edges(out.depth, noise, 2);
  for (std::size_t i = 0; i < out.weights.values.size(); ++i) {
    const double z = out.depth.values[i];
    if (z <= 0) continue;
    const double relative = noise.sigma(0.5) / noise.sigma(z);
    out.weights.values[i] *= static_cast<float>(relative * relative) * (edges.values[i] != 0 ? 0.1F : 1.0F);
  }
}

Eigen::Vector2f project(const CameraModel& camera, bool distorted, const Eigen::Vector3f& p) {
  if (distorted) {
    const auto pixel = camera.project(p.cast<double>());
    return pixel ? Eigen::Vector2f(pixel->cast<float>()) : Eigen::Vector2f(-1e6F, -1e6F);
  }
  return {static_cast<float>(camera.fx) * p.x() / p.z() + static_cast<float>(camera.cx),
          static_cast<float>(camera.fy) * p.y() / p.z() + static_cast<float>(camera.cy)};
}

void set_grid(Tsdf& grid, const Region& region, double voxel) {
  grid.voxel = voxel;
  grid.origin = region.min;
  grid.blocks = (region.size() / (voxel * size)).array().ceil().cast<int>().max(1);
}

std::size_t block_count(const Eigen::Vector3i& blocks) {
  return static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y()) *
         static_cast<std::size_t>(blocks.z());
}

// Marks the blocks along the lines of sight within the truncation of each depth.
void mark_blocks(const Tsdf& grid, const DepthView& view, std::vector<std::atomic<std::uint8_t>>& marks) {
  const Eigen::Isometry3f T_world_depth = view.T_depth_world.inverse();
  const float block = static_cast<float>(grid.voxel * size);
  const int steps = static_cast<int>(std::ceil(2 * grid.truncation / (0.5 * block))) + 1;
  tbb::parallel_for(tbb::blocked_range<int>(0, view.depth.height / 2, 16), [&](const auto& rows) {
    for (int row = rows.begin(); row < rows.end(); ++row)
      for (int x = row & 1; x < view.depth.width; x += 2) {
        const int y = 2 * row;
        const float z = view.depth.at(x, y);
        if (z <= 0) continue;
        const Eigen::Vector3f direction =
            view.distorted ? Eigen::Vector3f(view.depth_camera.direction({x, y}).cast<float>())
                           : Eigen::Vector3f((static_cast<float>(x) - static_cast<float>(view.depth_camera.cx)) /
                                                 static_cast<float>(view.depth_camera.fx),
                                             (static_cast<float>(y) - static_cast<float>(view.depth_camera.cy)) /
                                                 static_cast<float>(view.depth_camera.fy),
                                             1);
        for (int s = 0; s < steps; ++s) {
          const float at = z + static_cast<float>(grid.truncation) * (2.0F * s / (steps - 1) - 1.0F);
          const Eigen::Vector3f p = T_world_depth * Eigen::Vector3f(direction * at) - grid.origin.cast<float>();
          const Eigen::Array3i b = (p / block).array().floor().cast<int>();
          if ((b < 0).any() || (b >= grid.blocks.array()).any()) continue;
          const auto i = (static_cast<std::size_t>(b.x()) * grid.blocks.y() + b.y()) * grid.blocks.z() + b.z();
          marks[i].store(1, std::memory_order_relaxed);
        }
      }
  });
}

void integrate_block(const Tsdf& grid, const Eigen::Vector3i& place, Voxel* voxels, const DepthView& view) {
  const Eigen::Vector3f start = grid.position(place.x() * size, place.y() * size, place.z() * size).cast<float>();
  const float voxel = static_cast<float>(grid.voxel), truncation = static_cast<float>(grid.truncation);
  const Eigen::Vector3f middle = view.T_depth_world * Eigen::Vector3f(start.array() + 3.5F * voxel);
  if (middle.z() <= 8 * voxel) return;
  const Eigen::Vector2f centre = project(view.depth_camera, view.distorted, middle);
  const float reach = 8 * voxel * static_cast<float>(std::abs(view.depth_camera.fx)) / middle.z() + 2;
  if (centre.x() < -reach || centre.y() < -reach || centre.x() > static_cast<float>(view.depth.width) + reach ||
      centre.y() > static_cast<float>(view.depth.height) + reach)
    return;
  const Eigen::Matrix3f turn = view.T_depth_world.linear() * voxel;
  const Eigen::Vector3f corner = view.T_depth_world * start;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y) {
      Eigen::Vector3f p = corner + turn.col(0) * static_cast<float>(x) + turn.col(1) * static_cast<float>(y);
      for (int z = 0; z < size; ++z, p += turn.col(2)) {
        if (p.z() <= 0.01F) continue;
        const Eigen::Vector2f pixel = project(view.depth_camera, view.distorted, p);
        if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= static_cast<float>(view.depth.width - 1) &&
              pixel.y() <= static_cast<float>(view.depth.height - 1)))
          continue;
        const float depth = depth_at(view.depth, pixel.x(), pixel.y(), truncation);
        if (depth <= 0) continue;
        const float distance = depth - p.z();
        if (distance < -truncation) continue;
        const auto at =
            view.weights.index(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
        const float weight = view.weights.values[at] * (distance > truncation ? 0.5F : 1.0F);
        Voxel& v = voxels[(x * size + y) * size + z];
        const float sum = v.weight + weight;
        if (sum <= 0) continue;
        v.distance += (std::min(distance, truncation) - v.distance) * (weight / sum);
        if (distance < truncation && !view.color.empty()) {
          const Eigen::Vector3f world = start + voxel * Eigen::Vector3f(x, y, z);
          const Eigen::Vector3f in_color = view.T_color_world * world;
          if (in_color.z() > 0.01F) {
            const Eigen::Vector2f c = project(view.color_camera, view.color_distorted, in_color);
            const int cx = static_cast<int>(std::lround(c.x())), cy = static_cast<int>(std::lround(c.y()));
            if (view.color.contains(cx, cy)) {
              const float share = v.red + v.green + v.blue > 0 ? weight / sum : 1.0F;
              v.red += (static_cast<float>(view.color.at(cx, cy, 0)) - v.red) * share;
              v.green += (static_cast<float>(view.color.at(cx, cy, 1)) - v.green) * share;
              v.blue += (static_cast<float>(view.color.at(cx, cy, 2)) - v.blue) * share;
            }
          }
        }
        v.weight = sum;
      }
    }
}

double median_depth(const ViewSource& views, const std::vector<PosedView>& posed) {
  std::vector<float> some;
  View view;
  const std::size_t stride = std::max<std::size_t>(1, posed.size() / 8);
  for (std::size_t i = 0; i < posed.size(); i += stride) {
    views.read(posed[i].index, view, {.color = false, .depth = true, .mask = false});
    for (std::size_t k = 0; k < view.depth.values.size(); k += 61)
      if (const float z = view.depth.values[k]; z > 0 && std::isfinite(z)) some.push_back(z);
  }
  if (some.empty()) throw bad_input("no view has a depth above zero", "views with depth");
  const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
  std::ranges::nth_element(some, middle);
  return *middle;
}

}  // namespace

const Voxel* Tsdf::find(int x, int y, int z) const {
  if (x < 0 || y < 0 || z < 0 || x >= blocks.x() * size || y >= blocks.y() * size || z >= blocks.z() * size)
    return nullptr;
  const auto block = block_of[(static_cast<std::size_t>(x / size) * static_cast<std::size_t>(blocks.y()) +
                               static_cast<std::size_t>(y / size)) *
                                  static_cast<std::size_t>(blocks.z()) +
                              static_cast<std::size_t>(z / size)];
  if (block < 0) return nullptr;
  return &voxels[static_cast<std::size_t>(block) * block_voxels +
                 static_cast<std::size_t>(((x % size) * size + y % size) * size + z % size)];
}

std::optional<float> Tsdf::distance_at(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d u = (p - origin) / voxel;
  const Eigen::Vector3i i = u.array().floor().cast<int>();
  const Eigen::Vector3f f = (u - i.cast<double>()).cast<float>();
  float sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int cx = corner >> 2, cy = (corner >> 1) & 1, cz = corner & 1;
    const auto* v = find(i.x() + cx, i.y() + cy, i.z() + cz);
    if (v == nullptr || v->weight <= 0) return std::nullopt;
    sum += v->distance * (cx ? f.x() : 1 - f.x()) * (cy ? f.y() : 1 - f.y()) * (cz ? f.z() : 1 - f.z());
  }
  return sum;
}

Tsdf fuse_depth(const ViewSource& views, const std::vector<PosedView>& posed, const Region& region,
                const FuseOptions& options, const Run& run, Report& report) {
  if (!views.has_depth())
    throw bad_input("the views have no depth", "views of an RGB-D camera",
                    "Use plant.field without a start, or plant.match_views");
  const DepthNoise noise{options.depth_sigma};
  const double sigma = noise.sigma(median_depth(views, posed));
  Tsdf grid;
  View view;
  DepthView current;
  const double max_blocks = options.max_memory_mib * 1048576.0 / (Tsdf::block_voxels * sizeof(Voxel));
  double voxel = options.voxel;
  while ((region.size() / (voxel * size)).array().ceil().prod() > 200e6) voxel *= 1.25;
  for (;; voxel *= 1.25) {
    set_grid(grid, region, voxel);
    // Thin parts: with 3 sigma the two sides of a leaf, seen from opposite views, spoil one another.
    grid.truncation = options.truncation.value_or(std::max(4 * voxel, 1.5 * sigma));
    std::vector<std::atomic<std::uint8_t>> marks(block_count(grid.blocks));
    for (std::size_t i = 0; i < posed.size(); ++i) {
      run.check_cancel();
      run.report(0.4 * static_cast<double>(i) / static_cast<double>(posed.size()), "finding the surfaces");
      read_depth(views, posed[i], false, noise, view, current);
      mark_blocks(grid, current, marks);
      std::swap(view.depth, current.depth);
    }
    grid.block_of.assign(marks.size(), -1);
    grid.places.clear();
    for (int x = 0, i = 0; x < grid.blocks.x(); ++x)
      for (int y = 0; y < grid.blocks.y(); ++y)
        for (int z = 0; z < grid.blocks.z(); ++z, ++i)
          if (marks[static_cast<std::size_t>(i)].load(std::memory_order_relaxed) != 0) {
            grid.block_of[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(grid.places.size());
            grid.places.emplace_back(x, y, z);
          }
    if (static_cast<double>(grid.places.size()) <= max_blocks) break;
  }
  if (grid.places.empty())
    throw bad_input("no depth lies in the region", "depth of the plant",
                    "Check the region, the poses and the depth scale");
  if (voxel > options.voxel)
    report.find(Severity::look, "voxel_enlarged",
                "Voxels of " + std::to_string(options.voxel * 1000).substr(0, 5) + " mm need more than " +
                    std::to_string(options.max_memory_mib) + " MiB: " + std::to_string(voxel * 1000).substr(0, 5) +
                    " mm were used. Give a smaller region, or more memory.");
  grid.voxels.assign(grid.places.size() * Tsdf::block_voxels, {});
  for (std::size_t i = 0; i < posed.size(); ++i) {
    run.check_cancel();
    run.report(0.4 + 0.6 * static_cast<double>(i) / static_cast<double>(posed.size()), "fusing depth");
    read_depth(views, posed[i], true, noise, view, current);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.places.size(), 64), [&](const auto& range) {
      for (std::size_t b = range.begin(); b < range.end(); ++b)
        integrate_block(grid, grid.places[b], &grid.voxels[b * Tsdf::block_voxels], current);
    });
    std::swap(view.depth, current.depth);
    std::swap(view.color, current.color);
  }
  report.counts["blocks"] = static_cast<std::int64_t>(grid.places.size());
  report.metrics["voxel"] = {grid.voxel, Unit::metre};
  report.metrics["truncation"] = {grid.truncation, Unit::metre};
  return grid;
}

}  // namespace bole::plant
