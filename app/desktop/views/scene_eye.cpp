// Where the 3-D view is seen from, and what that makes of places of the world.
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/scene/view_camera.h"
#include "views/scene_camera.h"
#include "views/scene_view.h"

namespace bole::desktop {
std::optional<SceneEye> SceneView::eye() {
  if (parallel()) return {};
  auto* camera = renderer_->GetActiveCamera();
  const int* size = renderWindow()->GetSize();
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  SceneEye eye;
  eye.T_world_camera.linear().col(0) = ahead.cross(up).normalized();
  eye.T_world_camera.linear().col(1) = ahead.cross(eye.T_world_camera.linear().col(0));
  eye.T_world_camera.linear().col(2) = ahead;
  eye.T_world_camera.translation() = Eigen::Vector3d(camera->GetPosition()) + origin_;
  eye.tan_half_height = std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  eye.width_px = std::max(1, size[0]);
  eye.height_px = std::max(1, size[1]);
  return eye;
}

void SceneView::reset_camera() { look_along(Eigen::Vector3d(0.5, 1.0, -0.55), Eigen::Vector3d::UnitZ()); }

void SceneView::look_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  auto* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d from = -direction.normalized();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(from.x(), from.y(), from.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  if (const auto box = all_of_it()) {
    // Strays far away do not set the scale.
    fit_box(camera, box->lo - origin_, box->hi - origin_, static_cast<double>(width()) / std::max(1, height()));
    renderer_->ResetCameraClippingRange();
  } else {
    renderer_->ResetCamera();
  }
  eye_ = Eigen::Vector3d(camera->GetPosition());
  redraw();
}

bool SceneView::camera_moved() const {
  return !Eigen::Vector3d(renderer_->GetActiveCamera()->GetPosition()).isApprox(eye_, 1e-9);
}

void SceneView::set_parallel(bool on) {
  desktop::set_parallel(renderer_->GetActiveCamera(), on);
  redraw();
}

bool SceneView::parallel() const { return renderer_->GetActiveCamera()->GetParallelProjection() != 0; }

Eigen::Vector3d SceneView::centre() const {
  return Eigen::Vector3d(renderer_->GetActiveCamera()->GetFocalPoint()) + origin_;
}

Eigen::Vector3d SceneView::stem_place_of(std::int64_t tree) const {
  const auto it = std::ranges::find(shapes_, tree, &render::StemShape::tree_id);
  return it == shapes_.end() ? centre() : it->breast_height;
}

void SceneView::zoom_to(const Eigen::Vector3d& place) {
  if (flat())
    centre_on(renderer_->GetActiveCamera(), place - origin_);
  else
    approach(renderer_->GetActiveCamera(), place - origin_, approach_m);
  redraw();
}

void SceneView::zoom_to(const render::ClipBox& box) {
  fit_box(renderer_->GetActiveCamera(), box.lo - origin_, box.hi - origin_,
          static_cast<double>(width()) / std::max(1, height()));
  begin_motion();
  redraw();
}

void SceneView::fly(const Eigen::Vector3d& right_up_ahead_m, double right_rad, double up_rad) {
  desktop::fly(renderer_->GetActiveCamera(), right_up_ahead_m, right_rad, up_rad);
  begin_motion();
  redraw();
}

render::PickView SceneView::pick_view() {
  const int* size = renderer_->GetSize();
  const double aspect = static_cast<double>(std::max(size[0], 1)) / std::max(size[1], 1);
  return {render::view_matrix(renderer_->GetActiveCamera(), aspect), origin_, static_cast<double>(size[0]),
          static_cast<double>(size[1])};
}

Eigen::Vector2d SceneView::to_pixels(const QPoint& at) const {
  return Eigen::Vector2d(at.x(), height() - at.y()) * devicePixelRatioF();
}

QPoint SceneView::place_of(const Eigen::Vector3d& world) {
  const auto at = render::on_screen(pick_view(), world);
  if (!at) return {-1, -1};
  const Eigen::Vector2d px = at->px / devicePixelRatioF();
  return {static_cast<int>(std::lround(px.x())), static_cast<int>(std::lround(height() - px.y()))};
}

}  // namespace bole::desktop
