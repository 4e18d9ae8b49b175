// The cameras of views in the 3-D view: their path, a pyramid each, and the selected one with its picture.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <utility>
#include <vector>

#include "render/scene/camera_shapes.h"
#include "render/scene/point_layer.h"

namespace bole::desktop {

class CameraLayer {
 public:
  explicit CameraLayer(vtkRenderer* renderer) : renderer_(renderer) {}

  void set(std::vector<render::CameraShape> shapes);
  void set_picture(std::size_t view, ColorImage picture) { picture_ = {view, std::move(picture)}; }
  // `extent_m` of the scene without the cameras; 0: not known.
  void draw(const Eigen::Vector3d& origin, double extent_m, const std::optional<std::size_t>& selected, bool dark,
            double px_ratio);

  const std::vector<render::CameraShape>& shapes() const { return shapes_; }
  std::optional<render::ClipBox> box() const;  // around them; none without cameras
  std::optional<render::PickedCamera> at(const render::PickView& view, const Eigen::Vector2d& at_px,
                                         double reach_px) const;

 private:
  void put(vtkSmartPointer<vtkActor> actor);

  vtkRenderer* renderer_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  std::vector<render::CameraShape> shapes_;
  std::pair<std::size_t, ColorImage> picture_;
  double depth_m_ = 0;
};

}  // namespace bole::desktop
