// What of a cloud a camera sees, and how its depth compares with a measured one.
#pragma once

#include <cstdint>
#include <vector>

#include "base/run.h"
#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/point_cloud.h"

namespace bole::render {

struct SeenPoint {
  std::uint32_t index = 0;  // in the cloud
  float x = 0, y = 0;       // pixels; (0, 0) is the centre of the first pixel
  float depth_m = 0;        // along the camera's z
};

struct SeenCloud {
  std::vector<SeenPoint> points;  // in the order of the cloud
  DepthImage depth;               // of the seen point nearest to the middle of a pixel; 0 where there is none
};

// Median distance of a point from its nearest neighbour, by a sample. 0 for clouds of fewer than two places.
double point_spacing_m(const PointCloud& cloud, const Run& run = {});

// Points in the picture that no other point hides: each covers a square as wide as two spacings at its depth
// (point-splatting z-buffer), and counts as seen when it lies no more than three spacings and two pixels behind what
// covers it. Throws Error{bad_input} for a camera that check() refuses, Error{cancelled}.
SeenCloud see_cloud(const PointCloud& cloud, const CameraModel& camera, const Pose& T_world_camera, double spacing_m,
                    const Run& run = {});

// Measured minus the cloud's depth, metres; NaN where either is missing. Of images of one size, Error{failed}
// otherwise.
DepthImage depth_residual(const DepthImage& measured, const DepthImage& of_cloud);

}  // namespace bole::render
