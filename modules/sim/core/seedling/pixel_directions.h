// Directions of the pixels of a camera, undistorted once.
#pragma once

#include <vector>

#include "camera/camera_model.h"

namespace bole::sim {

class PixelDirections {
 public:
  explicit PixelDirections(const CameraModel& camera);
  const CameraModel& camera() const { return camera_; }
  // (x / z, y / z, 1) at any place of the image; for distorted cameras linear between pixels.
  Eigen::Vector3d at(double x, double y) const;

 private:
  CameraModel camera_;
  std::vector<Eigen::Vector2f> corners_;  // of pixels, by rows; empty without distortion
};

}  // namespace bole::sim
