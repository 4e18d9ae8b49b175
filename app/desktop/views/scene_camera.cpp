#include "views/scene_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::desktop {
namespace {

double perspective_half_height_m(vtkCamera* camera) {
  return camera->GetDistance() * std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
}

struct Screen {
  Eigen::Vector3d ahead, right, up;
};

Screen screen_of(vtkCamera* camera) {
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  const Eigen::Vector3d right = ahead.cross(up).normalized();
  return {ahead, right, right.cross(ahead)};
}

}  // namespace

double half_height_m(vtkCamera* camera) {
  return camera->GetParallelProjection() != 0 ? camera->GetParallelScale() : perspective_half_height_m(camera);
}

double north_on_screen_rad(vtkCamera* camera, const Eigen::Vector2d& north) {
  const auto screen = screen_of(camera);
  return -std::atan2(screen.right.head<2>().dot(north), screen.up.head<2>().dot(north));
}

void zoom_towards(vtkCamera* camera, const Eigen::Vector2d& off, double aspect, double factor) {
  const auto screen = screen_of(camera);
  const Eigen::Vector3d shift =
      (1 - 1 / factor) * half_height_m(camera) * (off.x() * aspect * screen.right + off.y() * screen.up);
  const Eigen::Vector3d target = Eigen::Vector3d(camera->GetFocalPoint()) + shift;
  const Eigen::Vector3d eye = target - camera->GetDistance() / factor * screen.ahead;
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  camera->SetParallelScale(camera->GetParallelScale() / factor);
}

void centre_on(vtkCamera* camera, const Eigen::Vector3d& target) {
  const Eigen::Vector3d eye =
      target + Eigen::Vector3d(camera->GetPosition()) - Eigen::Vector3d(camera->GetFocalPoint());
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
}

void approach(vtkCamera* camera, const Eigen::Vector3d& target, double distance_m) {
  Eigen::Vector3d from = -Eigen::Vector3d(camera->GetDirectionOfProjection());
  from.z() = std::clamp(from.z(), 0.15, 0.6);
  const Eigen::Vector3d eye = target + std::min(distance_m, std::max(camera->GetDistance(), 3.0)) * from.normalized();
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0, 0, 1);
  camera->SetParallelScale(3);
}

void fit_box(vtkCamera* camera, const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, double aspect) {
  constexpr double filled = 0.9, min_m = 0.5;
  const auto screen = screen_of(camera);
  const Eigen::Vector3d centre = (lo + hi) / 2;
  const double up_slope = filled * std::tan(camera->GetViewAngle() * std::numbers::pi / 360),
               right_slope = up_slope * aspect;
  double distance_m = min_m, half_height = min_m / 2;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d at((corner & 1) != 0 ? hi.x() : lo.x(), (corner & 2) != 0 ? hi.y() : lo.y(),
                             (corner & 4) != 0 ? hi.z() : lo.z());
    const Eigen::Vector3d off = at - centre;
    const double right = std::abs(off.dot(screen.right)), up = std::abs(off.dot(screen.up));
    distance_m =
        std::max({distance_m, right / right_slope - off.dot(screen.ahead), up / up_slope - off.dot(screen.ahead)});
    half_height = std::max({half_height, up / filled, right / aspect / filled});
  }
  const Eigen::Vector3d eye = centre - distance_m * screen.ahead;
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetParallelScale(half_height);
}

void fly(vtkCamera* camera, const Eigen::Vector3d& right_up_ahead_m, double right_rad, double up_rad) {
  constexpr double steepest_rad = 1.5;  // at the vertical there is no right
  const Eigen::Vector3d before(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  // Straight down the map's north is ahead.
  const Eigen::Vector2d level = before.head<2>().norm() > 1e-6 ? before.head<2>() : Eigen::Vector2d(up.head<2>());
  const double bearing = std::atan2(level.y(), level.x()) - right_rad,
               pitch = std::clamp(std::asin(std::clamp(before.z(), -1.0, 1.0)) + up_rad, -steepest_rad, steepest_rad);
  const Eigen::Vector3d ahead(std::cos(pitch) * std::cos(bearing), std::cos(pitch) * std::sin(bearing),
                              std::sin(pitch)),
      right(std::sin(bearing), -std::cos(bearing), 0);
  const Eigen::Vector3d eye = Eigen::Vector3d(camera->GetPosition()) + right_up_ahead_m.x() * right +
                              right_up_ahead_m.y() * Eigen::Vector3d::UnitZ() + right_up_ahead_m.z() * ahead,
                        target = eye + approach_m * ahead;
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(target.x(), target.y(), target.z());
  camera->SetViewUp(0, 0, 1);
}

void set_parallel(vtkCamera* camera, bool on) {
  if (on) camera->SetParallelScale(perspective_half_height_m(camera));
  camera->SetParallelProjection(on);
}

}  // namespace bole::desktop
