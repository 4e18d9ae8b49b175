#include "slam/core/odometry/features.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "slam/core/map/grid_key.h"

namespace bole::slam {
namespace {

constexpr int half_window = 5;  // neighbours on each side (LOAM)
constexpr int sectors = 6;      // sectors of a line, so that features lie all around
constexpr int edges_query = 2, edges_map = 12, planes_query = 4;
constexpr float edge_curvature = 0.1f, plane_curvature = 0.1f;
constexpr std::size_t min_connected = 3;
enum Unusable : std::uint8_t { no_edge = 1, no_plane = 2 };

FeaturePoint as_feature(const ScanPoint& p) { return {p.position, p.s}; }

}  // namespace

void thin_on_grid(std::vector<FeaturePoint>& points, double voxel) {
  GridKeySet seen(points.size());
  const float inverse = static_cast<float>(1.0 / voxel);
  std::erase_if(points, [&](const FeaturePoint& p) { return !seen.insert(grid_key(p.position * inverse)); });
}

void FeatureExtractor::extract(const Scan& scan, Features& features) {
  features.query.clear();
  features.map.clear();
  if (settings_.features != FeatureKind::sampled) return extract_curvature(scan, features);

  features.map.planes.reserve(scan.points.size());
  for (const auto& p : scan.points) features.map.planes.push_back(as_feature(p));
  thin_on_grid(features.map.planes, settings_.map_spacing);
  features.query.planes = features.map.planes;
  thin_on_grid(features.query.planes, settings_.query_spacing);
}

void FeatureExtractor::extract_curvature(const Scan& scan, Features& features) {
  std::vector<ScanLabel> labels;
  if (settings_.features == FeatureKind::ground) labels = label_scan(scan);
  for (std::size_t r = 0; r < scan.lines(); ++r) {
    const auto line = scan.line(r);
    extract_line(
        line,
        labels.empty() ? std::span<const ScanLabel>() : std::span(labels).subspan(scan.line_begin[r], line.size()),
        features);
  }
  thin_on_grid(features.map.edges, settings_.map_spacing);
  thin_on_grid(features.map.planes, settings_.map_spacing);
  thin_on_grid(features.query.planes, settings_.query_spacing);
}

// LOAM, section V-A: beside a step in range the farther points are about to be hidden, so an edge there is not an edge
// of the object, and points on surfaces nearly parallel to the ray are unstable. SPEC A2: the nearer side of a step is
// the outline of a round trunk, which moves with the viewer, and is rejected as well.
void FeatureExtractor::mark_unreliable(std::span<const ScanPoint> line) {
  const auto n = line.size();
  unusable_.assign(n, 0);
  const auto step = static_cast<float>(settings_.occlusion_step);
  const auto mark = [&](std::size_t i, std::ptrdiff_t direction, std::uint8_t kind) {
    for (std::ptrdiff_t k = 0, at = static_cast<std::ptrdiff_t>(i);
         k < half_window && at >= 0 && at < static_cast<std::ptrdiff_t>(n); ++k, at += direction)
      unusable_[static_cast<std::size_t>(at)] |= kind;
  };
  for (std::size_t i = 0; settings_.occlusion != Occlusion::none && i + 1 < n; ++i) {
    const float jump = line[i + 1].range - line[i].range;
    if (std::abs(jump) < step) continue;
    const bool after_is_farther = jump > 0;
    mark(after_is_farther ? i + 1 : i, after_is_farther ? 1 : -1, no_edge | no_plane);
    if (settings_.occlusion == Occlusion::both_sides) unusable_[after_is_farther ? i : i + 1] |= no_edge;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const float tilt = 0.0002f * line[i].range * line[i].range;
    if ((line[i + 1].position - line[i].position).squaredNorm() > tilt &&
        (line[i - 1].position - line[i].position).squaredNorm() > tilt)
      unusable_[i] |= no_plane;
  }
}

void FeatureExtractor::measure_curvature(std::span<const ScanPoint> line) {
  curvature_.assign(line.size(), 0);
  for (std::size_t i = half_window; i + half_window < line.size(); ++i) {
    Eigen::Vector3f sum = -2.0f * half_window * line[i].position;
    for (std::size_t k = 1; k <= half_window; ++k) sum += line[i - k].position + line[i + k].position;
    curvature_[i] = sum.squaredNorm();
  }
}

// A trunk is narrower than the window. Measured across the steps beside it, all its points look like edges, and the
// line that they make is the side of the trunk that faces the sensor: it turns with the observer. Walking past trunks
// of radius r at distance d shortens the path by r / d in this way. Measured among themselves, the points of a trunk
// are a surface.
void FeatureExtractor::measure_connected_curvature(std::span<const ScanPoint> line) {
  const auto n = line.size();
  const auto step = static_cast<float>(settings_.occlusion_step);
  curvature_.assign(n, 0);
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= n; ++end) {
    if (end < n && std::abs(line[end].range - line[end - 1].range) < step) continue;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t width = std::min({static_cast<std::size_t>(half_window), i - begin, end - 1 - i});
      Eigen::Vector3f sum = -2.0f * static_cast<float>(width) * line[i].position;
      for (std::size_t k = 1; k <= width; ++k) sum += line[i - k].position + line[i + k].position;
      curvature_[i] = sum.squaredNorm();
      if (end - begin < min_connected) unusable_[i] |= no_edge | no_plane;
    }
    begin = end;
  }
}

void FeatureExtractor::extract_line(std::span<const ScanPoint> line, std::span<const ScanLabel> labels,
                                    Features& features) {
  const auto n = line.size();
  if (n < 2 * half_window + 1) return;
  mark_unreliable(line);
  const auto is = [&](std::size_t i, ScanLabel label) { return labels.empty() || labels[i] == label; };
  const std::size_t first = half_window, last = n - half_window;
  const bool connected = settings_.features == FeatureKind::connected;
  connected ? measure_connected_curvature(line) : measure_curvature(line);

  for (std::size_t sector = 0; sector < sectors; ++sector) {
    const std::size_t begin = first + (last - first) * sector / sectors,
                      end = first + (last - first) * (sector + 1) / sectors;
    order_.resize(end - begin);
    std::iota(order_.begin(), order_.end(), static_cast<std::uint32_t>(begin));
    std::ranges::stable_sort(order_, {}, [&](std::uint32_t i) { return curvature_[i]; });

    const auto suppress_around = [&](std::size_t i, std::uint8_t kind) {
      for (std::size_t k = 0; k <= half_window; ++k) {
        unusable_[i - k] |= kind;
        unusable_[i + k] |= kind;
      }
    };
    int edges = 0;
    for (std::size_t o = order_.size(); o-- > 0 && edges < edges_map;) {
      const auto i = order_[o];
      if (curvature_[i] < edge_curvature) break;
      if ((unusable_[i] & no_edge) || !is(i, ScanLabel::object)) continue;
      if (edges < edges_query) features.query.edges.push_back(as_feature(line[i]));
      features.map.edges.push_back(as_feature(line[i]));
      ++edges;
      suppress_around(i, no_edge | no_plane);
    }
    int planes = 0;
    for (const auto i : order_) {
      if (curvature_[i] > plane_curvature) break;
      if ((unusable_[i] & no_plane) || (!labels.empty() && labels[i] == ScanLabel::loose)) continue;
      features.map.planes.push_back(as_feature(line[i]));
      if ((connected || planes < planes_query * 4) && is(i, ScanLabel::ground)) {
        features.query.planes.push_back(as_feature(line[i]));
        ++planes;
      }
    }
  }
}

}  // namespace bole::slam
