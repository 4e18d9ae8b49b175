// How the mouse moves the camera: z stays up, and a map is not turned but moved.
#pragma once

#include <vtkInteractorStyleTerrain.h>

namespace bole::desktop {

class MapStyle : public vtkInteractorStyleTerrain {
 public:
  static MapStyle* New();
  vtkTypeMacro(MapStyle, vtkInteractorStyleTerrain)
  void Rotate() override { flat ? Pan() : vtkInteractorStyleTerrain::Rotate(); }

  bool flat = false;
};

}  // namespace bole::desktop
