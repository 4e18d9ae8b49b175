// The points of a frame that are used for registration.
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
  void clear() {
    edges.clear();
    planes.clear();
  }
};

struct Features {
  FeatureSet query;  // sparse: registered against the map
  FeatureSet map;    // denser: what a keyframe adds to the map
};

// As settings.features says, see FeatureKind. `curvature`: Zhang and Singh 2014 (LOAM), section V-A, with the occlusion
// rules of settings.occlusion. `connected`: the same, but curvature is measured only among neighbours without a step in
// range between them, and planes are thinned on a grid instead of taking the flattest. `ground`: as `curvature`, but
// the planes to be registered lie on the ground, the edges on objects that stand on it, and loose points are left out
// (Shan and Englot 2018). `sampled`: points thinned on a voxel grid, all of them plane candidates.
class FeatureExtractor {
 public:
  explicit FeatureExtractor(const SlamSettings& settings) : settings_(settings) {}
  void extract(const Scan& scan, Features& features);

 private:
  void extract_curvature(const Scan& scan, Features& features);
  void extract_line(std::span<const ScanPoint> line, std::span<const ScanLabel> labels, Features& features);
  void measure_curvature(std::span<const ScanPoint> line);
  void measure_connected_curvature(std::span<const ScanPoint> line);
  void mark_unreliable(std::span<const ScanPoint> line);

  const SlamSettings settings_;
  std::vector<float> curvature_;        // squared metres; of the current line
  std::vector<std::uint8_t> unusable_;  // bits: no edge, no plane
  std::vector<std::uint32_t> order_;
  std::vector<FeaturePoint> candidates_;
};

// Keeps the first point of each voxel, in the order of `points`.
void thin_on_grid(std::vector<FeaturePoint>& points, double voxel);

}  // namespace bole::slam
