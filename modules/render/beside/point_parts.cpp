#include "render/beside/point_parts.h"

#include <vtkActor.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <utility>

namespace bole::render {

vtkStandardNewMacro(PointParts);

void PointParts::add(vtkActor* part) { parts_.emplace_back(part); }

void PointParts::remove(vtkActor* part) {
  if (std::erase(drawn_, part) > 0) bounded_ = false;
  std::erase(parts_, part);
  Modified();
}

void PointParts::clear() {
  show({});
  parts_.clear();
  Modified();
}

void PointParts::show(std::vector<vtkActor*> drawn) {
  if (drawn == drawn_) return;
  drawn_ = std::move(drawn);
  bounded_ = false;
}

double* PointParts::GetBounds() {
  if (drawn_.empty()) return nullptr;
  if (std::exchange(bounded_, true)) return bounds_;
  vtkBoundingBox box;
  for (auto* part : drawn_) box.AddBounds(part->GetBounds());
  box.GetBounds(bounds_);
  return bounds_;
}

int PointParts::RenderOpaqueGeometry(vtkViewport* viewport) {
  int rendered = 0;
  for (auto* part : drawn_) rendered += part->RenderOpaqueGeometry(viewport);
  return rendered;
}

void PointParts::ReleaseGraphicsResources(vtkWindow* window) {
  for (const auto& part : parts_) part->ReleaseGraphicsResources(window);
}

}  // namespace bole::render
