#include "render/beside/still_points_renderer.h"

#include <vtkCamera.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtk_glew.h>

namespace bole::render {
namespace {

constexpr int max_pixels = 4096 * 2304;  // 72 MiB; a picture of more is drawn once

vtkInformationIntegerKey* points_key() {
  static auto* key = vtkInformationIntegerKey::MakeKey("POINTS", "bole");
  return key;
}

// From the framebuffer that is read to the one that is drawn to, both of one size. False where the driver refuses, as
// it may for depths that are stored in two ways.
bool copy(const int* size) {
  const int all[4] = {0, size[0], 0, size[1]};
  while (glGetError() != GL_NO_ERROR) {
  }  // of others
  vtkOpenGLFramebufferObject::Blit(all, all, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return glGetError() == GL_NO_ERROR;
}

}  // namespace

vtkStandardNewMacro(StillPointsRenderer);

void StillPointsRenderer::mark(vtkProp& prop) {
  vtkNew<vtkInformation> keys;
  keys->Set(points_key(), 1);
  prop.SetPropertyKeys(keys);
}

StillPointsRenderer::Key StillPointsRenderer::key_of(const std::vector<vtkProp*>& points) {
  Key key;
  const auto add = [&](const double* values, int count) { key.eye.insert(key.eye.end(), values, values + count); };
  add(GetActiveCamera()->GetCompositeProjectionTransformMatrix(GetTiledAspectRatio(), -1, 1)->GetData(), 16);
  for (const int k : {0, 1}) key.eye.push_back(GetRenderWindow()->GetSize()[k]);
  add(GetBackground(), 3), add(GetBackground2(), 3);
  key.eye.push_back(GetGradientBackground() ? 1 : 0), key.eye.push_back(GetBackgroundAlpha());
  for (auto* p : points) key.points.emplace_back(p, p->GetRedrawMTime());
  return key;
}

// One picture fills one window, whose pixels have one sample.
bool StillPointsRenderer::can_keep() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  if (!keeps_ || refused_ || window == nullptr || window->GetRenderFramebuffer() == nullptr) return false;
  const double* view = GetViewport();
  const bool fills = view[0] == 0 && view[1] == 0 && view[2] == 1 && view[3] == 1;
  const int* size = window->GetSize();
  return fills && window->GetMultiSamples() <= 1 && size[0] > 0 && size[1] > 0 && size[0] <= max_pixels / size[1] &&
         window->GetRenderFramebuffer()->GetFBOIndex() != 0;
}

void StillPointsRenderer::draw(const std::vector<vtkProp*>& props) {
  for (auto* p : props) NumberOfPropsRendered += p->RenderOpaqueGeometry(this);
}

void StillPointsRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  std::vector<vtkProp*> points, others;
  for (int i = 0; i < PropArrayCount; ++i) {
    auto* keys = PropArray[i]->GetPropertyKeys();
    (keys != nullptr && keys->Has(points_key()) != 0 ? points : others).push_back(PropArray[i]);
  }
  if (points.empty() || !can_keep()) {
    kept_ = {};
    if (!points.empty()) ++drawn_;
    Superclass::DeviceRenderOpaqueGeometry(target);
    return;
  }
  if (key_of(points) == kept_) {
    put_back(), ++reused_;
  } else {
    draw(points), ++drawn_;
    refused_ = !put_aside();
    kept_ = refused_ ? Key{} : key_of(points);  // being drawn for the first time changes their times
  }
  draw(others);
}

bool StillPointsRenderer::put_aside() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  auto* state = window->GetState();
  const int* size = window->GetSize();
  state->PushFramebufferBindings();
  picture_->SetContext(window);
  if (const int* last = picture_->GetLastSize();
      last[0] != size[0] || last[1] != size[1] || picture_->GetFBOIndex() == 0) {
    picture_->ReleaseGraphicsResources(window);
    picture_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, 32, 0, false);
  }
  window->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window->GetRenderFramebuffer()->ActivateReadBuffer(0);
  picture_->Bind(GL_DRAW_FRAMEBUFFER);
  picture_->ActivateDrawBuffer(0);
  const bool copied = copy(size);
  state->PopFramebufferBindings();
  return copied;
}

void StillPointsRenderer::put_back() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  auto* state = window->GetState();
  state->PushFramebufferBindings();
  picture_->Bind(GL_READ_FRAMEBUFFER);
  picture_->ActivateReadBuffer(0);
  window->GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
  window->GetRenderFramebuffer()->ActivateDrawBuffer(0);
  copy(window->GetSize());
  state->PopFramebufferBindings();
}

void StillPointsRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  kept_ = {};
  picture_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace bole::render
