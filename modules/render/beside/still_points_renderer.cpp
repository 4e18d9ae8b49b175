#include "render/beside/still_points_renderer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkProp.h>

#include <algorithm>
#include <utility>

namespace bole::render {
namespace {

constexpr int max_pixels = 4096 * 2304;  // 72 MiB; a picture of more is drawn once

}  // namespace

vtkStandardNewMacro(StillPointsRenderer);

void StillPointsRenderer::draw_afresh(vtkProp* prop) {
  std::erase_if(afresh_, [](const auto& known) { return known == nullptr; });
  afresh_.emplace_back(prop);
}

// Of actors it is known when they changed.
StillPointsRenderer::Shown StillPointsRenderer::shown() {
  Shown shown;
  const auto is_afresh = [&](const vtkProp* prop) {
    return std::ranges::any_of(afresh_, [&](const auto& known) { return known.Get() == prop; });
  };
  for (int i = 0; i < PropArrayCount; ++i) {
    auto* prop = PropArray[i];
    if (auto* cloud = PointParts::SafeDownCast(prop))
      shown.clouds.push_back(cloud);
    else if (vtkActor::SafeDownCast(prop) != nullptr && !is_afresh(prop))
      shown.solids.push_back(prop);
    else
      shown.others.push_back(prop);
  }
  return shown;
}

vtkOpenGLRenderWindow& StillPointsRenderer::window() { return *vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow()); }

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

bool StillPointsRenderer::any_missing(const std::vector<PointParts*>& clouds) const {
  return std::ranges::any_of(clouds, [&](auto* cloud) {
    const auto it = kept_.find(cloud);
    const auto is_missing = [&](auto* part) { return it == kept_.end() || !it->second.parts.contains(part); };
    return std::ranges::any_of(cloud->drawn(), is_missing);
  });
}

// All that is in the picture is to be drawn, as it was.
bool StillPointsRenderer::solids_hold(const std::vector<vtkProp*>& solids) const {
  const auto is_kept = [&](vtkProp* prop) {
    const auto it = kept_solids_.find(prop);
    return it != kept_solids_.end() && it->second == prop->GetRedrawMTime();
  };
  return !kept_solids_.empty() &&
         static_cast<std::size_t>(std::ranges::count_if(solids, is_kept)) == kept_solids_.size();
}

void StillPointsRenderer::draw_points(const std::vector<PointParts*>& clouds, bool holds, std::vector<double> eye) {
  kept_solids_.clear();
  if (holds)
    points_.put_back(window());
  else
    forget();
  if (add_missing(clouds)) {
    ++drawn_;
    refused_ = !points_.put_aside(window());
    if (refused_)
      forget();
    else
      eye_ = std::move(eye);
  } else if (holds) {
    ++reused_;
  } else {
    forget();  // no points: there is no picture of them
  }
}

void StillPointsRenderer::draw_solids(const std::vector<vtkProp*>& solids) {
  bool added = false;
  for (auto* prop : solids) {
    if (kept_solids_.contains(prop)) continue;
    NumberOfPropsRendered += prop->RenderOpaqueGeometry(this);
    added = true;
  }
  if (!added || eye_.empty() || !whole_) return;
  kept_solids_.clear();
  if (!with_solids_.put_aside(window())) return;
  for (auto* prop : solids) kept_solids_.emplace(prop, prop->GetRedrawMTime());
}

void StillPointsRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
  const auto [clouds, solids, others] = shown();
  if (clouds.empty() || !can_keep()) {
    forget();
    whole_ = true;
    if (!clouds.empty()) ++drawn_;
    Superclass::DeviceRenderOpaqueGeometry(target);
    return;
  }
  auto now = eye();
  const bool holds = still_holds(clouds, now);
  if (holds && !any_missing(clouds) && solids_hold(solids)) {
    with_solids_.put_back(window());
    whole_ = true;
    ++reused_, ++reused_with_solids_;
  } else {
    draw_points(clouds, holds, std::move(now));
  }
  draw_solids(solids);
  for (auto* p : others) NumberOfPropsRendered += p->RenderOpaqueGeometry(this);
}

void StillPointsRenderer::forget() {
  eye_.clear();
  kept_.clear();
  kept_solids_.clear();
}

void StillPointsRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  forget();
  points_.release(window);
  with_solids_.release(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace bole::render
