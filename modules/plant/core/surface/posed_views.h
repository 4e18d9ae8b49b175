// The views of a source that have a pose, and the quality of their depth.
#pragma once

#include <vector>

#include "base/report.h"
#include "cloud/core/view_source.h"

namespace bole::plant {

struct PosedView {
  std::size_t index = 0;  // in the source
  Pose T_world_camera = Pose::Identity();
};

// The views with a pose, in the order of the source. Throws Error{bad_input} when there are fewer than `min_views`; a
// warning counts the views without a pose.
std::vector<PosedView> posed_views(const ViewSource& views, const Trajectory& poses, std::size_t min_views,
                                   Report& report);

// Standard deviation of a depth by triangulation: it grows with the square of the distance.
struct DepthNoise {
  double sigma_at_half_metre = 0.0015;
  double sigma(double z) const;
};

// Pixels within `reach` pixels of a jump in depth (255), where stereo matching thickens the nearer surface and time of
// flight mixes both.
MaskImage depth_edges(const DepthImage& depth, const DepthNoise& noise, int reach);

// Weight of each depth pixel in [0, 1]: the cosine between the surface and the line of sight. 0 without depth.
DepthImage viewing_cosines(const DepthImage& depth, const CameraModel& camera);

// Depth at a subpixel position: bilinear where the four neighbours agree, else the nearest pixel; 0 where there is
// none.
float depth_at(const DepthImage& depth, float x, float y, float max_difference);

}  // namespace bole::plant
