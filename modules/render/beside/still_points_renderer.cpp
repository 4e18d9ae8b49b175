#include "render/beside/still_points_renderer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtk_glew.h>

#include <algorithm>
#include <utility>

namespace bole::render {
namespace {

constexpr int max_pixels = 4096 * 2304;  // 72 MiB; a picture of more is drawn once

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

std::vector<double> StillPointsRenderer::eye() {
  std::vector<double> eye;
  const auto add = [&](const double* values, int count) { eye.insert(eye.end(), values, values + count); };
  add(GetActiveCamera()->GetCompositeProjectionTransformMatrix(GetTiledAspectRatio(), -1, 1)->GetData(), 16);
  for (const int k : {0, 1}) eye.push_back(GetRenderWindow()->GetSize()[k]);
  add(GetBackground(), 3), add(GetBackground2(), 3);
  eye.push_back(GetGradientBackground() ? 1 : 0), eye.push_back(GetBackgroundAlpha());
  return eye;
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

// All that is in the picture is to be drawn, as it was.
bool StillPointsRenderer::still_holds(const std::vector<PointParts*>& clouds, const std::vector<double>& eye) const {
  if (eye_.empty() || eye != eye_) return false;
  std::size_t found = 0;
  for (auto* cloud : clouds) {
    const auto it = kept_.find(cloud);
    if (it == kept_.end()) continue;
    if (it->second.time != cloud->GetMTime()) return false;
    const auto& kept = it->second.parts;
    const auto there = std::ranges::count_if(cloud->drawn(), [&](auto* part) { return kept.contains(part); });
    if (static_cast<std::size_t>(there) != kept.size()) return false;
    ++found;
  }
  return found == kept_.size();
}

// False: nothing was missing.
bool StillPointsRenderer::add_missing(const std::vector<PointParts*>& clouds) {
  const std::size_t share = most_ / clouds.size();
  bool added = false;
  whole_ = true;
  for (auto* cloud : clouds) {
    auto& kept = kept_[cloud];
    kept.time = cloud->GetMTime();
    std::size_t points = 0;
    for (auto* part : cloud->drawn()) {
      if (kept.parts.contains(part)) continue;
      if (points >= share && points > 0) {
        whole_ = false;
        break;
      }
      NumberOfPropsRendered += part->RenderOpaqueGeometry(this);
      points += static_cast<std::size_t>(part->GetMapper()->GetInput()->GetNumberOfPoints());
      kept.parts.insert(part);
    }
    added = added || points > 0;
  }
  return added;
}

void StillPointsRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  std::vector<PointParts*> clouds;
  std::vector<vtkProp*> others;
  for (int i = 0; i < PropArrayCount; ++i)
    if (auto* cloud = PointParts::SafeDownCast(PropArray[i]))
      clouds.push_back(cloud);
    else
      others.push_back(PropArray[i]);
  if (clouds.empty() || !can_keep()) {
    forget();
    whole_ = true;
    if (!clouds.empty()) ++drawn_;
    Superclass::DeviceRenderOpaqueGeometry(target);
    return;
  }
  auto now = eye();
  const bool holds = still_holds(clouds, now);
  if (holds)
    put_back();
  else
    forget();
  if (add_missing(clouds)) {
    ++drawn_;
    refused_ = !put_aside();
    if (refused_)
      forget();
    else
      eye_ = std::move(now);
  } else if (holds) {
    ++reused_;
  } else {
    forget();  // no points: there is no picture of them
  }
  for (auto* p : others) NumberOfPropsRendered += p->RenderOpaqueGeometry(this);
}

void StillPointsRenderer::forget() {
  eye_.clear();
  kept_.clear();
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
  forget();
  picture_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace bole::render
