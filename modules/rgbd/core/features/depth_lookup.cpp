#include "rgbd/core/features/depth_lookup.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"

namespace bole::rgbd {
namespace {

constexpr int half_window = 2;        // pixels of the depth image
constexpr int min_values = 12;        // of the 25 in the window
constexpr double max_scatter = 0.01;  // of the inverse depth: more is an edge, or noise that helps nobody
constexpr int coarse_cell = 8;        // colour pixels
constexpr int search_steps = 6;
constexpr double same_depth = 1e-5;  // relative change that ends the search
constexpr double max_miss_px = 0.5;  // of the colour pixel, where the search has ended

bool usable(float z) { return std::isfinite(z) && z > 0; }

}  // namespace

DepthLookup::DepthLookup(const DepthImage& depth, const RgbdCamera& camera) : depth_(&depth), camera_(&camera) {
  if (depth.empty()) return;
  const auto& model = camera.of_depth();
  if (depth.width != model.width || depth.height != model.height)
    throw bad_input("a depth image is " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                        " pixels, its camera " + std::to_string(model.width) + " x " + std::to_string(model.height),
                    "one size", "Give the depth camera (depth, depth_to_color), or depth registered to colour.");
  if (!camera.depth) return;
  T_depth_color_ = camera.T_color_depth.inverse();
  make_coarse();
}

void DepthLookup::make_coarse() {
  const auto& color = camera_->color;
  coarse_ = DepthImage(color.width / coarse_cell + 1, color.height / coarse_cell + 1);
  constexpr int step = 2;  // the cells are wide enough
  for (int y = 0; y < depth_->height; y += step)
    for (int x = 0; x < depth_->width; x += step) {
      const float z = depth_->at(x, y);
      if (!usable(z)) continue;
      const Eigen::Vector3d p =
          camera_->T_color_depth * (camera_->depth->direction(Eigen::Vector2d(x, y)) * static_cast<double>(z));
      const auto pixel = color.project(p);
      if (!pixel || !color.contains(*pixel)) continue;
      const int cx = static_cast<int>(std::lround(pixel->x())) / coarse_cell;
      const int cy = static_cast<int>(std::lround(pixel->y())) / coarse_cell;
      if (!coarse_.contains(cx, cy)) continue;
      float& cell = coarse_.at(cx, cy);
      if (cell <= 0 || p.z() < static_cast<double>(cell)) cell = static_cast<float>(p.z());
    }
}

double DepthLookup::coarse_depth(const Eigen::Vector2d& pixel) const {
  const int cx = static_cast<int>(std::lround(pixel.x())) / coarse_cell;
  const int cy = static_cast<int>(std::lround(pixel.y())) / coarse_cell;
  for (int reach = 0; reach <= 1; ++reach) {
    float nearest = 0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (coarse_.contains(cx + dx, cy + dy))
          if (const float z = coarse_.at(cx + dx, cy + dy); z > 0 && (nearest <= 0 || z < nearest)) nearest = z;
    if (nearest > 0) return static_cast<double>(nearest);
  }
  return 0;
}

std::optional<double> DepthLookup::fit(const Eigen::Vector2d& depth_pixel) const {
  const int cx = static_cast<int>(std::lround(depth_pixel.x())), cy = static_cast<int>(std::lround(depth_pixel.y()));
  if (!depth_->contains(cx, cy)) return std::nullopt;
  struct Value {
    double x, y, w;
  };
  std::array<Value, (2 * half_window + 1) * (2 * half_window + 1)> values;
  int count = 0;
  for (int y = std::max(0, cy - half_window); y <= std::min(depth_->height - 1, cy + half_window); ++y)
    for (int x = std::max(0, cx - half_window); x <= std::min(depth_->width - 1, cx + half_window); ++x)
      if (const float z = depth_->at(x, y); usable(z))
        values[static_cast<std::size_t>(count++)] = {x - depth_pixel.x(), y - depth_pixel.y(),
                                                     1 / static_cast<double>(z)};
  if (count < min_values) return std::nullopt;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    const auto& v = values[static_cast<std::size_t>(i)];
    const Eigen::Vector3d row(1, v.x, v.y);
    A += row * row.transpose();
    b += row * v.w;
  }
  const Eigen::Vector3d plane = A.ldlt().solve(b);
  if (!plane.allFinite() || !(plane[0] > 0)) return std::nullopt;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const auto& v = values[static_cast<std::size_t>(i)];
    const double r = v.w - plane.dot(Eigen::Vector3d(1, v.x, v.y));
    sum += r * r;
  }
  if (std::sqrt(sum / count) > max_scatter * plane[0]) return std::nullopt;
  return plane[0];
}

std::optional<double> DepthLookup::inverse_depth(const Eigen::Vector2d& pixel, const Eigen::Vector3d& direction) const {
  if (depth_->empty()) return std::nullopt;
  if (!camera_->depth) return fit(pixel);
  double z = coarse_depth(pixel);
  if (!(z > 0)) return std::nullopt;
  // The depth pixel depends on the depth and the depth on the pixel: in turn, until both agree.
  for (int i = 0; i < search_steps; ++i) {
    const auto at = camera_->depth->project(T_depth_color_ * (direction * z));
    if (!at || !camera_->depth->contains(*at)) return std::nullopt;
    const auto w = fit(*at);
    if (!w) return std::nullopt;
    const Eigen::Vector3d p = camera_->T_color_depth * (camera_->depth->direction(*at) / *w);
    if (!(p.z() > 0)) return std::nullopt;
    const double change = std::abs(p.z() - z);
    z = p.z();
    if (change > same_depth * z && i + 1 < search_steps) continue;
    const auto back = camera_->color.project(p);
    if (!back || (*back - pixel).norm() > max_miss_px) return std::nullopt;
    return 1 / z;
  }
  return std::nullopt;
}

}  // namespace bole::rgbd
