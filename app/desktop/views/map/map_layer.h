// A map below the survey in the 3-D view: a picture of the place, flat at the foot of what is drawn or over the
// terrain.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "cloud/raster.h"
#include "render/beside/ground_picture.h"
#include "render/beside/surroundings.h"

namespace bole::desktop {

struct SceneMap {
  std::shared_ptr<const render::GroundPicture> picture;
  std::shared_ptr<const render::GroundPicture> coarse;  // of the same place, for views from afar; null: none is needed
  double pixel_m = 1;                                   // of `picture`
  render::GroundCorners corners;                        // world x and y
  Eigen::Vector2d north = Eigen::Vector2d::UnitY();     // of its coordinate system, in world axes; unit
};

class MapLayer {
 public:
  explicit MapLayer(vtkRenderer* renderer) : renderer_(renderer) {}

  void set(std::shared_ptr<const SceneMap> map);  // null: none; drawn by draw()
  const std::shared_ptr<const SceneMap>& map() const { return map_; }
  // Over the terrain, or flat at the height `z`, world coordinates; null: none. `origin` of the scene.
  void draw(const Eigen::Vector3d& origin, double z, const Raster* terrain, double opacity);
  void hide();
  // As it is drawn now.
  const std::optional<render::PlacedPicture>& shown() const { return shown_; }
  void suit(double metres_per_px);  // of the view: before a frame

 private:
  vtkTexture* texture();

  vtkRenderer* renderer_;
  std::shared_ptr<const SceneMap> map_;
  vtkSmartPointer<vtkTexture> fine_, coarse_;  // made when they are needed
  vtkSmartPointer<vtkActor> actor_;
  std::optional<render::PlacedPicture> shown_;
  double metres_per_px_ = 1e9;
};

}  // namespace bole::desktop
