// The points of a frame that take part in registration.
#pragma once

#include <vector>

#include "slam/core/odometry/ground.h"
#include "slam/core/odometry/scan.h"
#include "slam/core/options.h"

namespace bole::slam {

struct FeaturePoint {
  Eigen::Vector3f position;  // sensor axes at the point's own firing time
  float s = 0;               // time within the frame, 0 to 1
};

// Edge points are matched to lines, plane points to planes.
struct FeatureSet {
  std::vector<FeaturePoint> edges, planes;
  std::size_t size() const { return edges.size() + planes.size(); }
  void clear() { edges.clear(), planes.clear(); }
};

struct Features {
  FeatureSet query;  // sparse: registered against the map
  FeatureSet map;    // denser: what a key frame adds to the map
};

// By options.features: "curvature" (LOAM: Zhang and Singh 2014, section V-A, with the occlusion rules of
// options.occlusion), "connected" (the same, but curvature is measured among neighbours without a step in range between
// them, and planes are thinned on a grid in place of taking the smoothest), "ground" (the same, but the planes to be
// registered lie on the ground, edges on things that stand on it, and what is loose is left out: Shan and Englot 2018)
// or "sampled" (points thinned on a voxel grid, all of them plane candidates).
class FeatureExtractor {
 public:
  explicit FeatureExtractor(const SlamOptions& options) : options_(options) {}
  void extract(const Scan& scan, Features& features);

 private:
  void extract_curvature(const Scan& scan, Features& features);
  void extract_line(std::span<const ScanPoint> line, std::span<const ScanLabel> labels, Features& features);
  void measure_curvature(std::span<const ScanPoint> line);
  void measure_connected_curvature(std::span<const ScanPoint> line);
  void mark_unreliable(std::span<const ScanPoint> line);

  const SlamOptions options_;
  std::vector<float> curvature_;        // squared metres; of the line in work
  std::vector<std::uint8_t> unusable_;  // bits: no edge, no plane
  std::vector<std::uint32_t> order_;
  std::vector<FeaturePoint> candidates_;
};

// One point per voxel: the first met. `points` is replaced by the kept ones, in their order.
void thin_on_grid(std::vector<FeaturePoint>& points, double voxel_m);

}  // namespace bole::slam
