#include "views/map/terrain_layer.h"

namespace bole::desktop {

void TerrainLayer::draw(const std::shared_ptr<const Raster>& terrain, const Eigen::Vector3d& origin, bool lines_only) {
  if (terrain == terrain_ && origin == origin_ && lines_only == lines_only_) return;
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
  const auto surface = terrain ? render::terrain_surface(*terrain, origin) : render::TerrainSurface();
  for (const auto& actor : {lines_only ? nullptr : surface.ground, surface.contours})
    if (actor) {
      renderer_->AddActor(actor);
      actors_.push_back(actor);
    }
  contour_step_m_ = surface.contour_step_m;
  terrain_ = terrain;
  origin_ = origin;
  lines_only_ = lines_only;
}

}  // namespace bole::desktop
