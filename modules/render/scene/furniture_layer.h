// Draws the furniture of a 3-D view into its window, above the scene, and the shadow of eye-dome shading between them.
#pragma once

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexturedActor2D.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "camera/image.h"
#include "render/draw/screen_look.h"
#include "render/scene/view_furniture.h"

namespace bole::render {

class FurnitureLayer {
 public:
  FurnitureLayer();

  // To be added to the window as layer 1.
  vtkRenderer* renderer() { return renderer_; }

  // Takes effect with the next frame. Only patches whose state is new are drawn.
  void show(const ViewFurniture& furniture, double px_per_mm);

  // Words and inks from now on.
  void set_look(const ScreenLook& look);

  // Black of this opacity over each pixel, rows from below; an empty one takes it away.
  void set_shadow(const std::vector<std::uint8_t>& alpha, int width, int height);

  // A picture that fills the window, over the scene and below all else; the window's size in pixels.
  void show_picture(const ColorImage& picture, int width, int height);
  void hide_picture();

 private:
  struct Slot {
    vtkSmartPointer<vtkActor2D> actor;
    std::uint64_t last_use = 0;
  };
  struct LineActor {
    vtkSmartPointer<vtkActor2D> actor;
    vtkSmartPointer<vtkPolyData> data;
  };
  void forget_patches();
  void draw_lines(const ViewFurniture& furniture, double px_per_mm);

  ScreenLook look_;
  vtkNew<vtkRenderer> renderer_;
  std::unordered_map<std::string, Slot> slots_;
  // Drawn in the order in which they were added: picture, shadow, lines with their rims, patches.
  vtkSmartPointer<vtkTexturedActor2D> picture_, shadow_;
  std::vector<LineActor> lines_;
  std::uint64_t round_ = 0;
  double px_per_mm_ = 0;  // of the patches in slots_
};

}  // namespace bole::render
