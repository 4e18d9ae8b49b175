// The terrain of the survey as a surface in the 3-D view.
#pragma once

#include <vtkRenderer.h>

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "cloud/raster.h"
#include "render/beside/surroundings.h"
#include "render/beside/terrain_surface.h"

namespace bole::desktop {

class TerrainLayer {
 public:
  explicit TerrainLayer(vtkRenderer* renderer) : renderer_(renderer) {}

  // Null: none. `lines_only`: over a map that follows the terrain. What was drawn stays where all is as before, as
  // after an edit of stems.
  void draw(const std::shared_ptr<const Raster>& terrain, const Eigen::Vector3d& origin, bool lines_only);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }  // as drawn
  std::optional<render::ShownTerrain> shown() const {
    return terrain_ ? std::optional(render::ShownTerrain{terrain_, lines_only_}) : std::nullopt;
  }
  double contour_step_m() const { return contour_step_m_; }  // 0: no contour lines

 private:
  vtkRenderer* renderer_;
  std::shared_ptr<const Raster> terrain_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  bool lines_only_ = false;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  double contour_step_m_ = 0;
};

}  // namespace bole::desktop
