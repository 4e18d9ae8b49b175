#include "views/map_layer.h"

#include <utility>

namespace bole::desktop {

void MapLayer::set(std::shared_ptr<const SceneMap> map) {
  map_ = std::move(map);
  texture_ = map_ ? render::ground_texture(map_->picture) : nullptr;
}

void MapLayer::draw(const Eigen::Vector3d& origin, double z, bool visible, double opacity) {
  if (actor_) renderer_->RemoveActor(actor_);
  actor_ = nullptr;
  if (!map_ || !visible) return;
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = Eigen::Vector3d(map_->corners[k].x(), map_->corners[k].y(), z) - origin;
  actor_ = render::ground_actor(texture_, corners, opacity);
  renderer_->AddActor(actor_);
}

}  // namespace bole::desktop
