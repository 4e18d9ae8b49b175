#include "render/beside/kept_picture.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

namespace bole::render {
namespace {

// From the framebuffer that is read to the one that is drawn to, both of one size.
bool copy(const int* size) {
  const int all[4] = {0, size[0], 0, size[1]};
  while (glGetError() != GL_NO_ERROR) {
  }  // of others
  vtkOpenGLFramebufferObject::Blit(all, all, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return glGetError() == GL_NO_ERROR;
}

}  // namespace

bool KeptPicture::put_aside(vtkOpenGLRenderWindow& window) {
  auto* state = window.GetState();
  const int* size = window.GetSize();
  state->PushFramebufferBindings();
  pixels_->SetContext(&window);
  if (const int* last = pixels_->GetLastSize();
      last[0] != size[0] || last[1] != size[1] || pixels_->GetFBOIndex() == 0) {
    pixels_->ReleaseGraphicsResources(&window);
    pixels_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, 32, 0, false);
  }
  window.GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window.GetRenderFramebuffer()->ActivateReadBuffer(0);
  pixels_->Bind(GL_DRAW_FRAMEBUFFER);
  pixels_->ActivateDrawBuffer(0);
  const bool copied = copy(size);
  state->PopFramebufferBindings();
  return copied;
}

void KeptPicture::put_back(vtkOpenGLRenderWindow& window) {
  auto* state = window.GetState();
  state->PushFramebufferBindings();
  pixels_->Bind(GL_READ_FRAMEBUFFER);
  pixels_->ActivateReadBuffer(0);
  window.GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
  window.GetRenderFramebuffer()->ActivateDrawBuffer(0);
  copy(window.GetSize());
  state->PopFramebufferBindings();
}

void KeptPicture::release(vtkWindow* window) { pixels_->ReleaseGraphicsResources(window); }

}  // namespace bole::render
