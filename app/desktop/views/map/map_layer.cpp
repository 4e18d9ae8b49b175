#include "views/map/map_layer.h"

#include <utility>

#include "render/beside/draped_ground.h"

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

void MapLayer::hide() {
  if (actor_) renderer_->RemoveActor(actor_);
  actor_ = nullptr;
  shown_.reset();
}

void MapLayer::draw(const Eigen::Vector3d& origin, double z, const Raster* terrain, double opacity) {
  hide();
  if (!map_) return;
  shown_ = render::PlacedPicture{
      map_->picture,
      terrain != nullptr ? render::draped_ground(map_->corners, *terrain, z) : render::flat_ground(map_->corners, z),
      opacity};
  actor_ = render::ground_actor(texture(), shown_->places, origin, opacity);
  renderer_->AddActor(actor_);
}

}  // namespace bole::desktop
