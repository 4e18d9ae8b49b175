#include "views/map/map_layer.h"

#include <utility>

namespace bole::desktop {
namespace {

constexpr double coarse_from_px = 2.5;  // pixels of the map on one of the screen

}  // namespace

void MapLayer::set(std::shared_ptr<const SceneMap> map) {
  map_ = std::move(map);
  fine_ = nullptr;
  coarse_ = nullptr;
}

vtkTexture* MapLayer::texture() {
  const bool far = map_->coarse && metres_per_px_ > coarse_from_px * map_->pixel_m;
  auto& texture = far ? coarse_ : fine_;
  if (!texture) texture = render::ground_texture(far ? map_->coarse : map_->picture, far || !map_->coarse);
  return texture;
}

void MapLayer::suit(double metres_per_px) {
  metres_per_px_ = metres_per_px;
  if (actor_ && actor_->GetTexture() != texture()) actor_->SetTexture(texture());
}

void MapLayer::draw(const Eigen::Vector3d& origin, double z, bool visible, double opacity) {
  if (actor_) renderer_->RemoveActor(actor_);
  actor_ = nullptr;
  if (!map_ || !visible) return;
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = Eigen::Vector3d(map_->corners[k].x(), map_->corners[k].y(), z) - origin;
  actor_ = render::ground_actor(texture(), corners, opacity);
  renderer_->AddActor(actor_);
}

}  // namespace bole::desktop
