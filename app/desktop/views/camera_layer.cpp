#include "views/camera_layer.h"

#include <algorithm>
#include <cmath>

#include "render/draw/screen_look.h"

namespace bole::desktop {
namespace {

constexpr double path_px = 2, edge_px = 1, selected_px = 3;

}  // namespace

void CameraLayer::put(vtkSmartPointer<vtkActor> actor) {
  if (!actor) return;
  renderer_->AddActor(actor);
  actors_.push_back(std::move(actor));
}

void CameraLayer::set(std::vector<render::CameraShape> shapes) {
  shapes_ = std::move(shapes);
  if (shapes_.empty()) picture_ = {};
}

std::optional<render::ClipBox> CameraLayer::box() const {
  if (shapes_.empty()) return {};
  const double depth_m = render::camera_depth_m(shapes_, 0);
  render::ClipBox box{Eigen::Vector3d::Constant(1e300), Eigen::Vector3d::Constant(-1e300)};
  for (const auto& shape : shapes_)
    for (const auto& [a, b] : render::camera_edges(shape, depth_m))
      for (const auto& p : {a, b}) {
        box.lo = box.lo.cwiseMin(p);
        box.hi = box.hi.cwiseMax(p);
      }
  return box;
}

void CameraLayer::draw(const Eigen::Vector3d& origin, double extent_m, const std::optional<std::size_t>& selected,
                       bool dark, double px_ratio) {
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
  if (shapes_.empty()) return;
  Eigen::Vector3d lo = shapes_.front().T_world_camera.translation(), hi = lo;
  for (const auto& shape : shapes_) {
    lo = lo.cwiseMin(shape.T_world_camera.translation());
    hi = hi.cwiseMax(shape.T_world_camera.translation());
  }
  depth_m_ = render::camera_depth_m(shapes_, std::hypot(extent_m, (hi - lo).norm()));
  const auto shown = [&](const render::Color& color) { return dark ? render::on_dark(color) : color; };
  put(render::eyes_actor(shapes_, origin, shown(render::ink::path), path_px * px_ratio));
  put(render::cameras_actor(shapes_, depth_m_, origin, shown(render::ink::primary), edge_px * px_ratio));
  const auto it = selected ? std::ranges::find(shapes_, *selected, &render::CameraShape::view) : shapes_.end();
  if (it == shapes_.end()) return;
  // Larger than its neighbours, so that it stands out among them.
  const double depth_m = 1.6 * depth_m_;
  put(render::cameras_actor({*it}, depth_m, origin, shown(render::ink::accent), selected_px * px_ratio));
  if (picture_.first != *selected) return;
  put(render::picture_actor(*it, picture_.second, depth_m, origin));
}

std::optional<render::PickedCamera> CameraLayer::at(const render::PickView& view, const Eigen::Vector2d& at_px,
                                                    double reach_px) const {
  return render::pick_camera(view, shapes_, depth_m_, at_px, reach_px);
}

}  // namespace bole::desktop
