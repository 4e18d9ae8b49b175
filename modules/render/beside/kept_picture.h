// Colours and depths of a window's frame, put aside and put back.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace bole::render {

// Of a window whose pixels have one sample, while one of its renderers draws.
class KeptPicture {
 public:
  // False where the driver refuses, as it may for depths that are stored in two ways.
  bool put_aside(vtkOpenGLRenderWindow& window);
  // What was put aside of this window, which has had the same size since.
  void put_back(vtkOpenGLRenderWindow& window);
  void release(vtkWindow* window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> pixels_;
};

}  // namespace bole::render
