// A pinhole camera with the distortion of OpenCV, and the pair of cameras of an RGB-D sensor.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "base/transform.h"

namespace bole {
inline namespace camera {

// Camera axes: x right, y down, z ahead. Brown's distortion (Zhang 2000, OpenCV): k1, k2, p1, p2, k3.
struct CameraModel {
  int width = 0, height = 0;           // pixels
  double fx = 0, fy = 0;               // pixels; fy < 0 in images whose rows run upwards
  double cx = 0, cy = 0;               // pixels; (0, 0) is the centre of the first pixel
  std::array<double, 5> distortion{};  // without unit

  bool operator==(const CameraModel&) const = default;

  bool distorted() const;
  // Pixel of a point in camera axes; nothing for a point that is not ahead of the camera. The pixel may lie outside of
  // the image.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_camera) const;
  // The same and its derivative by the point (2 x 3).
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_camera,
                                         Eigen::Matrix<double, 2, 3>& jacobian) const;
  // Direction (x / z, y / z, 1) of a pixel: times the depth it is the point. The distortion is undone by iteration.
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const;
  bool contains(const Eigen::Vector2d& pixel) const;

  // The camera of the image made `factor` times as large (0.5: half as wide and high). Its size is rounded.
  CameraModel scaled(double factor) const;

  // Throws Error{bad_input} that names the value: sizes below 1, focal lengths that are zero or no number, a principal
  // point far outside, a distortion that folds the image.
  void check() const;
};

// Colour and depth camera of one sensor. Without `depth` the depth image is registered to the colour image.
struct RgbdCamera {
  CameraModel color;
  std::optional<CameraModel> depth;
  Pose T_color_depth = Pose::Identity();
  double depth_scale = 1000;  // units of the depth image per metre

  const CameraModel& of_depth() const { return depth ? *depth : color; }
};

}  // namespace camera
}  // namespace bole
