// Depth images of several views that agree, as one cloud.
#pragma once

#include <memory>
#include <vector>

#include "base/run.h"
#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/point_cloud.h"

namespace bole::plant {

// Directions of the pixels of a camera, (x / z, y / z), two floats a pixel: distortion is undone once.
using PixelDirections = Image<float>;
std::shared_ptr<const PixelDirections> pixel_directions(const CameraModel& camera);

// One view's depth, with what is needed to look points up in it. `local` axes are world axes about an origin.
struct DepthMap {
  CameraModel camera;
  std::shared_ptr<const PixelDirections> directions;
  const ColorImage* color = nullptr;
  Eigen::Isometry3f T_camera_local = Eigen::Isometry3f::Identity(), T_local_camera = Eigen::Isometry3f::Identity();
  DepthImage depth;  // along z; 0: none
};

struct DepthMapOptions {
  double tolerance = 0.002;  // largest difference of depths that agree, metres
  int min_views = 3;         // that must agree on a point, its own among them
  double spacing = 0.0005;   // one point per cube of this edge; 0: all
};

// Points that several views have at the same place, with normals (towards the cameras), colours, and the number of
// views that agree (column "views", int32). Counts into the report: depths_seen, depths_kept, points.
PointCloud cloud_of_depth_maps(const std::vector<DepthMap>& maps, const Eigen::Vector3d& origin,
                               const DepthMapOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
