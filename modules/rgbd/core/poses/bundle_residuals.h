// The residuals of the bundle adjustment, for Ceres's automatic derivatives. q: T_world_camera's rotation as Eigen
// keeps quaternions (x, y, z, w); t: its translation; all residuals in standard deviations.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "camera/camera_model.h"

namespace bole::rgbd {

inline constexpr double min_depth = 1e-3;  // metres; nearer points have no image

template <class T>
Eigen::Matrix<T, 3, 1> in_camera(const T* q, const T* t, const Eigen::Matrix<T, 3, 1>& point) {
  const Eigen::Map<const Eigen::Quaternion<T>> turn(q);
  const Eigen::Map<const Eigen::Matrix<T, 3, 1>> place(t);
  return turn.conjugate() * (point - place);
}

template <class T>
bool pixel_error(const CameraModel& c, const T& focal, const Eigen::Matrix<T, 3, 1>& p, const Eigen::Vector2d& pixel,
                 double weight, T* r) {
  if (p.z() < T(min_depth)) return false;
  const T x = p.x() / p.z(), y = p.y() / p.z();
  const auto& d = c.distortion;
  const T r2 = x * x + y * y;
  const T radial = T(1) + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  const T u = x * radial + 2 * d[2] * x * y + d[3] * (r2 + T(2) * x * x);
  const T v = y * radial + d[2] * (r2 + T(2) * y * y) + 2 * d[3] * x * y;
  r[0] = weight * (focal * c.fx * u + c.cx - pixel.x());
  r[1] = weight * (focal * c.fy * v + c.cy - pixel.y());
  return true;
}

struct PixelError {
  const CameraModel* camera;
  Eigen::Vector2d pixel;
  double weight;
  template <class T>
  bool operator()(const T* q, const T* t, const T* point, const T* focal, T* r) const {
    return pixel_error<T>(*camera, *focal, in_camera<T>(q, t, Eigen::Matrix<T, 3, 1>(point)), pixel, weight, r);
  }
};

struct KnownError {
  const CameraModel* camera;
  Eigen::Vector3d point;
  Eigen::Vector2d pixel;
  double weight;
  template <class T>
  bool operator()(const T* q, const T* t, const T* focal, T* r) const {
    return pixel_error<T>(*camera, *focal, in_camera<T>(q, t, point.cast<T>()), pixel, weight, r);
  }
};

struct DepthError {
  double inverse_depth, weight;
  template <class T>
  bool operator()(const T* q, const T* t, const T* point, const T* depth, T* r) const {
    const T z = depth[0] * in_camera<T>(q, t, Eigen::Matrix<T, 3, 1>(point)).z() + depth[1];
    if (z < T(min_depth)) return false;
    r[0] = weight * (inverse_depth - T(1) / z);
    return true;
  }
};

struct PriorError {
  std::array<double, 2> value, weight;
  template <class T>
  bool operator()(const T* x, T* r) const {
    for (int i = 0; i < 2; ++i)
      r[i] = weight[static_cast<std::size_t>(i)] * (x[i] - value[static_cast<std::size_t>(i)]);
    return true;
  }
};

// Holds the length of a shift; the weight is so large that the length stays to a millionth.
struct LengthError {
  Eigen::Vector3d from;
  double length;
  template <class T>
  bool operator()(const T* t, T* r) const {
    constexpr double weight = 1e4;
    r[0] = weight * ((Eigen::Matrix<T, 3, 1>(t) - from.cast<T>()).norm() / length - T(1));
    return true;
  }
};

}  // namespace bole::rgbd
