#include "views/clip_handles.h"

#include <vtkCommand.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

namespace bole::desktop {

ClipHandles::ClipHandles(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
                         std::function<void(const render::ClipBox&)> moved)
    : moved_(std::move(moved)) {
  box_->SetPlaceFactor(1);
  box_->SetHandleSize(7);
  box_->GetOutlineProperty()->SetColor(0.35, 0.4, 0.44);
  box_->GetHandleProperty()->SetColor(0.12, 0.37, 0.55);
  widget_->SetInteractor(interactor);
  widget_->SetDefaultRenderer(renderer);
  widget_->SetRepresentation(box_);
  widget_->RotationEnabledOff();  // along the axes only
  widget_->ScalingEnabledOff();   // the right button would
  widget_->AddObserver(vtkCommand::InteractionEvent, this, &ClipHandles::tell);
}

void ClipHandles::show(const render::ClipBox& box, const Eigen::Vector3d& origin) {
  origin_ = origin;
  const Eigen::Vector3d lo = box.lo - origin, hi = box.hi - origin;
  double bounds[6] = {lo.x(), hi.x(), lo.y(), hi.y(), lo.z(), hi.z()};
  box_->PlaceWidget(bounds);
  widget_->On();
}

void ClipHandles::tell() {
  const double* b = box_->GetBounds();
  moved_({Eigen::Vector3d(b[0], b[2], b[4]) + origin_, Eigen::Vector3d(b[1], b[3], b[5]) + origin_});
}

}  // namespace bole::desktop
