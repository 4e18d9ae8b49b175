// The parts of a cloud as one thing of a scene.
#pragma once

#include <vtkBoundingBox.h>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;

namespace bole::render {

// VTK asks everything in a scene several times a frame for its bounds, its time and whether it is translucent. A cloud
// of a thousand parts that are not drawn anew would cost more than all that is.
class PointParts : public vtkProp {
 public:
  static PointParts* New();
  vtkTypeMacro(PointParts, vtkProp)

  // Opaque ones, to be drawn by show(). Call Modified() when one changes; it is called where one goes.
  void add(vtkActor* part);
  void remove(vtkActor* part);
  void clear();
  // Of the parts, the most important first. The others keep what the graphics card has of them.
  void show(std::vector<vtkActor*> drawn);
  const std::vector<vtkActor*>& drawn() const { return drawn_; }

  double* GetBounds() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  PointParts() = default;
  ~PointParts() override = default;

 private:
  std::vector<vtkSmartPointer<vtkActor>> parts_;
  std::vector<vtkActor*> drawn_;
  double bounds_[6]{};
  bool bounded_ = false;
};

}  // namespace bole::render
