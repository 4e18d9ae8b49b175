#include "render/scene/view_camera.h"

#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"

namespace bole::render {
namespace {

void place(vtkCamera* camera, const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetFocalPoint(target.x(), target.y(), target.z());
}

}  // namespace

Box rectangle_on_view(const Eigen::Matrix4d& matrix, const std::vector<Eigen::Vector3d>& points) {
  Box box{1e9, 1e9, -1e9, -1e9};
  for (const auto& p : points) {
    const Eigen::Vector4d v = matrix * p.homogeneous();
    box = {std::min(box.x0, v.x() / v.w()), std::min(box.y0, v.y() / v.w()), std::max(box.x1, v.x() / v.w()),
           std::max(box.y1, v.y() / v.w())};
  }
  return box;
}

Eigen::Matrix4d view_matrix(vtkCamera* camera, double aspect) {
  auto* m = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  Eigen::Matrix4d matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix(r, c) = m->GetElement(r, c);
  return matrix;
}

void aim_from_above(vtkCamera* camera, const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double aspect) {
  camera->ParallelProjectionOn();
  place(camera, centre + Eigen::Vector3d(0, 0, 10 * size.norm()), centre);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelScale(std::max(size.y(), size.x() / aspect) / 2);
  camera->SetClippingRange(size.norm(), 20 * size.norm());
}

void aim_obliquely(vtkCamera* camera, const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double aspect,
                   const std::vector<Eigen::Vector3d>& outline, double azimuth_deg, double elevation_deg) {
  const double azimuth = radians(azimuth_deg), elevation = radians(elevation_deg);
  const Eigen::Vector3d direction(std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                                  std::sin(elevation));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(direction).normalized(), up = direction.cross(right);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(24);
  double distance = 2.6 * size.norm();
  Eigen::Vector3d target = centre;
  // Move back and sideways until all of it just fits.
  for (int round = 0; round < 6; ++round) {
    place(camera, target + distance * direction, target);
    camera->SetClippingRange(0.05 * distance, 4 * distance);
    const Box seen = rectangle_on_view(view_matrix(camera, aspect), outline);
    const double half_height = distance * std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
    target += right * seen.centre().x() * half_height * aspect + up * seen.centre().y() * half_height;
    distance *= std::max(seen.width(), seen.height()) / 2 * 1.03;
  }
  place(camera, target + distance * direction, target);
  camera->SetClippingRange(std::max(0.1, distance - size.norm()), distance + size.norm());
}

}  // namespace bole::render
