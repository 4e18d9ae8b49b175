// A box in the 3-D view whose faces are dragged by handles.
#pragma once

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkNew.h>

#include <functional>

#include "render/scene/point_layer.h"

class vtkRenderWindowInteractor;

namespace bole::desktop {

class ClipHandles {
 public:
  // `moved` is called while a handle is dragged; boxes are in world axes.
  ClipHandles(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
              std::function<void(const render::ClipBox&)> moved);

  void show(const render::ClipBox& box, const Eigen::Vector3d& origin);
  void hide() { widget_->Off(); }
  bool shown() { return widget_->GetEnabled() != 0; }

 private:
  void tell();

  vtkNew<vtkBoxWidget2> widget_;
  vtkNew<vtkBoxRepresentation> box_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::function<void(const render::ClipBox&)> moved_;
};

}  // namespace bole::desktop
