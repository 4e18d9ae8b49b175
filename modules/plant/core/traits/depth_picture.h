// What is nearest to a camera, in blocks of pixels: whether a cloud hides a place.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "camera/camera_model.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

class DepthPicture {
 public:
  // `cloud` in plant axes; `spacing`: how far its points lie apart, which is how large they are drawn.
  DepthPicture(const CameraModel& camera, const Pose& T_camera_plant, const Points3& cloud, double spacing);

  // Whether something lies nearer than `depth` (camera's z) where `pixel` is.
  bool hides(const Eigen::Vector2d& pixel, double depth) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  int columns_, rows_;
  std::vector<float> nearest_;
};

}  // namespace bole::plant
