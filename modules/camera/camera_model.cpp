#include "camera/camera_model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace bole {
inline namespace camera {
namespace {

struct Distorted {
  Eigen::Vector2d point;
  Eigen::Matrix2d jacobian;  // by the point without distortion
};

// Brown's model on the plane z = 1.
Distorted distort(const std::array<double, 5>& d, const Eigen::Vector2d& p) {
  const auto [k1, k2, p1, p2, k3] = d;
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = k1 + r2 * (2 * k2 + r2 * 3 * k3);  // of `radial` by r2
  Distorted out;
  out.point = {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
               y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
  out.jacobian(0, 0) = radial + 2 * x * x * slope + 2 * p1 * y + 6 * p2 * x;
  out.jacobian(0, 1) = 2 * x * y * slope + 2 * p1 * x + 2 * p2 * y;
  out.jacobian(1, 0) = out.jacobian(0, 1);
  out.jacobian(1, 1) = radial + 2 * y * y * slope + 6 * p1 * y + 2 * p2 * x;
  return out;
}

constexpr double min_depth = 1e-6;  // metres; nearer points have no image

}  // namespace

bool CameraModel::distorted() const {
  return std::ranges::any_of(distortion, [](double k) { return k != 0; });
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point_in_camera) const {
  if (!(point_in_camera.z() > min_depth)) return std::nullopt;
  Eigen::Vector2d p = point_in_camera.head<2>() / point_in_camera.z();
  if (distorted()) p = distort(distortion, p).point;
  return Eigen::Vector2d(fx * p.x() + cx, fy * p.y() + cy);
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point_in_camera,
                                                    Eigen::Matrix<double, 2, 3>& jacobian) const {
  if (!(point_in_camera.z() > min_depth)) return std::nullopt;
  const double inverse = 1 / point_in_camera.z();
  const Eigen::Vector2d p = point_in_camera.head<2>() * inverse;
  const auto bent = distort(distortion, p);
  Eigen::Matrix<double, 2, 3> by_point;
  by_point << inverse, 0, -p.x() * inverse, 0, inverse, -p.y() * inverse;
  jacobian = Eigen::Vector2d(fx, fy).asDiagonal() * bent.jacobian * by_point;
  return Eigen::Vector2d(fx * bent.point.x() + cx, fy * bent.point.y() + cy);
}

Eigen::Vector3d CameraModel::direction(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d seen((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  if (!distorted()) return seen.homogeneous();
  Eigen::Vector2d p = seen;
  for (int i = 0; i < 20; ++i) {
    const auto bent = distort(distortion, p);
    const Eigen::Vector2d step = bent.jacobian.inverse() * (seen - bent.point);
    if (!step.allFinite()) break;
    p += step;
    if (step.squaredNorm() < 1e-24) break;
  }
  return p.homogeneous();
}

bool CameraModel::contains(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
}

CameraModel CameraModel::scaled(double factor) const {
  CameraModel out = *this;
  out.width = std::max(1, static_cast<int>(std::lround(width * factor)));
  out.height = std::max(1, static_cast<int>(std::lround(height * factor)));
  const double sx = static_cast<double>(out.width) / width, sy = static_cast<double>(out.height) / height;
  out.fx = fx * sx, out.fy = fy * sy;
  out.cx = (cx + 0.5) * sx - 0.5, out.cy = (cy + 0.5) * sy - 0.5;  // pixels are areas, counted from their centres
  return out;
}

void CameraModel::check() const {
  const auto found = [](const char* name, double value) {
    return std::string("the camera's ") + name + " is " + std::to_string(value);
  };
  if (width < 1 || height < 1)
    throw bad_input("the camera's image is " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
                    "at least 1 x 1");
  for (const auto& [name, value] : {std::pair{"fx", fx}, {"fy", fy}})
    if (!std::isfinite(value) || std::abs(value) < 1) throw bad_input(found(name, value), "pixels, 1 or more");
  for (const auto& [name, value, size] : {std::tuple{"cx", cx, width}, {"cy", cy, height}})
    if (!(std::abs(value - size / 2.0) <= size)) throw bad_input(found(name, value), "a pixel near the image's middle");
  for (const double k : distortion)
    if (!std::isfinite(k)) throw bad_input(found("distortion", k), "five numbers: k1, k2, p1, p2, k3");
  // Where the distortion folds the image, a pixel has no direction.
  for (const double x : {0.0, width - 1.0})
    for (const double y : {0.0, height - 1.0}) {
      const auto back = project(direction({x, y}));
      if (!back || (*back - Eigen::Vector2d(x, y)).norm() > 0.01)
        throw bad_input("the camera's distortion has no inverse at the corners of the image",
                        "k1, k2, p1, p2, k3 as OpenCV gives them");
    }
}

}  // namespace camera
}  // namespace bole
