// The depth at a pixel of the colour image, also where the depth camera is another one.
#pragma once

#include <optional>

#include "camera/camera_model.h"
#include "camera/image.h"

namespace bole::rgbd {

// Both arguments must outlive it. Throws Error{bad_input} where the depth image has not the size of its camera.
class DepthLookup {
 public:
  DepthLookup(const DepthImage& depth, const RgbdCamera& camera);

  // Inverse depth (1 / m) along z of the colour camera at a colour pixel, by a plane through the values around it (the
  // inverse depth of a plane is linear in the pixels). Nothing where values are missing, or at an edge.
  std::optional<double> inverse_depth(const Eigen::Vector2d& pixel, const Eigen::Vector3d& direction) const;

 private:
  std::optional<double> fit(const Eigen::Vector2d& depth_pixel) const;
  void make_coarse();
  double coarse_depth(const Eigen::Vector2d& pixel) const;

  const DepthImage* depth_;
  const RgbdCamera* camera_;
  Pose T_depth_color_ = Pose::Identity();
  DepthImage coarse_;  // in the colour camera, the nearest of each cell: where the search begins
};

}  // namespace bole::rgbd
