#include "plant/core/traits/view_stem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plant/core/traits/picture_tone.h"

namespace bole::plant {
namespace {

constexpr int depth_block = 4;  // pixels

int block_index(double v) { return static_cast<int>(std::floor((v + 0.5) / depth_block)); }

const std::array<float, 256>& light_table() {
  static const auto table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < 256; ++i) t[i] = static_cast<float>(light_of_code(static_cast<double>(i) / 255));
    return t;
  }();
  return table;
}

// How far from its axis points may be the stem's own.
double clearance(const StripSearch& search, double spacing) { return std::max(4 * search.radius, 3 * spacing); }

}  // namespace

NearestDepth::NearestDepth(const CameraModel& camera)
    : columns_(camera.width / depth_block + 1),
      rows_(camera.height / depth_block + 1),
      nearest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
               std::numeric_limits<float>::max()) {}

void NearestDepth::add(const Eigen::Vector2d& pixel, double splat, float depth) {
  for (int y = std::max(0, block_index(pixel.y() - splat)); y <= std::min(rows_ - 1, block_index(pixel.y() + splat));
       ++y)
    for (int x = std::max(0, block_index(pixel.x() - splat));
         x <= std::min(columns_ - 1, block_index(pixel.x() + splat)); ++x) {
      auto& d = nearest_[index(x, y)];
      d = std::min(d, depth);
    }
}

float NearestDepth::at(const Eigen::Vector2d& pixel) const {
  const int x = block_index(pixel.x()), y = block_index(pixel.y());
  if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return std::numeric_limits<float>::max();
  return nearest_[index(x, y)];
}

ViewStem::ViewStem(const CameraModel& camera, const Pose& T_plant_camera, const StripSearch& search)
    : camera_(camera), T_plant_camera_(T_plant_camera), search_(search) {
  const Pose T_camera_plant = T_plant_camera.inverse();
  for (int i = 0; i < search.sections; ++i) {
    const double z = search.bottom + (i + 0.5) * (search.top - search.bottom) / search.sections;
    const Eigen::Vector3d p = T_camera_plant * search.axis.at(z);
    const double step = 0.25 * search.radius;
    const Eigen::Vector3d q = T_camera_plant * (search.axis.at(z) + step * search.axis.tangent(z));
    const auto at = camera.project(p), next = camera.project(q);
    if (!at || !next || !camera.contains(*at)) continue;
    ViewSection s;
    s.z = z;
    s.depth = p.z();
    s.place = *at;
    const Eigen::Vector2d d = *next - *at;
    // Looked at along its axis a stem has no sides.
    if (d.norm() < 0.35 * step * std::abs(camera.fx) / p.z()) continue;
    s.along = d.normalized();
    s.across = {-s.along.y(), s.along.x()};
    s.pixels_per_unit = std::abs(camera.fx) / p.z();
    sections_.push_back(s);
  }
}

Eigen::Vector3d ViewStem::ray(const Eigen::Vector2d& pixel) const {
  return (T_plant_camera_.linear() * camera_.direction(pixel)).normalized();
}

std::size_t ViewStem::remove_hidden(const NearestDepth& nearest, double spacing) {
  const double room = clearance(search_, spacing) / 2;
  return static_cast<std::size_t>(std::erase_if(sections_, [&](const ViewSection& s) {
    const double half = std::min(search_.radius * s.pixels_per_unit + 2.0, max_half_width_px);
    for (double off = -half; off <= half; off += depth_block / 2.0)
      if (nearest.at(s.place + off * s.across) < s.depth - room) return true;
    return false;
  }));
}

std::vector<StripPixel> ViewStem::pixels_of(const ViewSection& s, double half_length, const ColorImage& image) const {
  std::vector<StripPixel> out;
  const double reach = half_length + 1;
  const int x0 = std::max(0, static_cast<int>(std::floor(s.place.x() - reach)));
  const int x1 = std::min(image.width - 1, static_cast<int>(std::ceil(s.place.x() + reach)));
  const int y0 = std::max(0, static_cast<int>(std::floor(s.place.y() - reach)));
  const int y1 = std::min(image.height - 1, static_cast<int>(std::ceil(s.place.y() + reach)));
  const auto& light = light_table();
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const Eigen::Vector2d d(x - s.place.x(), y - s.place.y());
      const double across = d.dot(s.across);
      if (std::abs(across) > half_length || std::abs(d.dot(s.along)) > 0.75) continue;
      StripPixel p;
      p.across = across;
      for (int c = 0; c < 3; ++c) {
        const auto code = image.at(x, y, c);
        p.value[static_cast<std::size_t>(c)] = search_.linear_light ? light[code] : code / 255.0;
      }
      out.push_back(p);
    }
  return out;
}

NearestDepth depth_around(const CameraModel& camera, const Pose& T_camera_plant, std::span<const ViewStem> stems,
                          std::span<const StripSearch> searches, const Points3& cloud, double spacing) {
  constexpr double border = 2 * max_half_width_px + 20;
  constexpr double far = std::numeric_limits<double>::max();
  Eigen::Vector2d low(far, far), high(-far, -far);
  for (const auto& stem : stems)
    for (const auto& s : stem.sections()) {
      low = low.cwiseMin(s.place);
      high = high.cwiseMax(s.place);
    }
  const auto of_stem = [&](const Eigen::Vector3d& p) {
    return std::ranges::any_of(searches, [&](const StripSearch& search) {
      const double clear = clearance(search, spacing);
      return p.z() > search.bottom - clear && p.z() < search.top + clear &&
             (p - search.axis.at(p.z())).head<2>().norm() < clear;
    });
  };
  NearestDepth nearest(camera);
  for (const auto& p : cloud) {
    const Eigen::Vector3d c = T_camera_plant * p;
    const auto at = camera.project(c);
    if (!at || at->x() < low.x() - border || at->y() < low.y() - border || at->x() > high.x() + border ||
        at->y() > high.y() + border || of_stem(p))
      continue;
    nearest.add(*at, 0.7 * spacing * std::abs(camera.fx) / c.z(), static_cast<float>(c.z()));
  }
  return nearest;
}

}  // namespace bole::plant
