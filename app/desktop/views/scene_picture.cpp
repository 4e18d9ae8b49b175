// The 3-D view as a picture of any size, and the places to come back to.
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <QImage>
#include <QThread>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr int max_side_px = 12000, max_frames = 60;  // frames until all points are loaded
constexpr int wait_ms = 50, max_waits = 400;         // for points that come from the disk

QImage image_of(vtkRenderWindow* window) {
  vtkNew<vtkWindowToImageFilter> read;
  read->SetInput(window);
  read->SetInputBufferTypeToRGBA();
  read->ReadFrontBufferOff();
  read->ShouldRerenderOff();
  read->Update();
  auto* data = read->GetOutput();
  const int width = data->GetDimensions()[0], height = data->GetDimensions()[1];
  const auto* pixels = static_cast<const uchar*>(data->GetScalarPointer());
  // Rows from below; what is drawn on nothing has its colour multiplied by its alpha.
  return QImage(pixels, width, height, 4 * width, QImage::Format_RGBA8888_Premultiplied)
      .mirrored()
      .convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

QImage SceneView::picture(int width_px, bool transparent) {
  if (!isValid()) throw failure("the 3-D view was not drawn yet", "a view on the screen", "Show the window first");
  auto* window = renderWindow();
  const int before[2] = {window->GetSize()[0], window->GetSize()[1]};
  const double scale = static_cast<double>(width_px) / std::max(1, before[0]);
  const int height_px = static_cast<int>(std::lround(scale * before[1]));
  if (width_px < 16 || std::max(width_px, height_px) > max_side_px)
    throw bad_input("a picture of " + std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels",
                    "16 to " + std::to_string(max_side_px) + " pixels a side");
  makeCurrent();
  const double alpha = renderer_->GetBackgroundAlpha();
  const Eigen::Vector3d ground(renderer_->GetBackground());
  moving_ = false;
  at_once_ = true;
  // What is faded lets the background through, which is black where there is none: image_of().
  renderer_->SetBackgroundAlpha(transparent ? 0 : 1);
  if (transparent) renderer_->SetBackground(0, 0, 0);
  size_points(scale);
  window->SetSize(width_px, height_px);
  for (int frame = 0; frame == 0 || (!complete_ && frame < max_frames); ++frame) window->Render();
  for (int wait = 0; (awaited() > 0 || !complete_) && wait < max_waits; ++wait) {
    QThread::msleep(wait_ms);
    window->Render();
  }
  QImage picture = image_of(window);
  if (!transparent) picture = picture.convertToFormat(QImage::Format_RGB888);
  renderer_->SetBackgroundAlpha(alpha);
  renderer_->SetBackground(ground.x(), ground.y(), ground.z());
  at_once_ = false;
  size_points();
  window->SetSize(before[0], before[1]);
  redraw();
  return picture;
}

ViewPoint SceneView::view_point() const {
  auto* camera = renderer_->GetActiveCamera();
  ViewPoint point;
  point.eye = Eigen::Vector3d(camera->GetPosition()) + origin_;
  point.centre = Eigen::Vector3d(camera->GetFocalPoint()) + origin_;
  point.up = Eigen::Vector3d(camera->GetViewUp());
  point.parallel = parallel();
  point.half_height_m = camera->GetParallelScale();
  return point;
}

void SceneView::set_view_point(const ViewPoint& point) {
  auto* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d eye = point.eye - origin_, centre = point.centre - origin_;
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(point.up.data());
  camera->SetParallelProjection(point.parallel);
  camera->SetParallelScale(point.half_height_m);
  begin_motion();
  redraw();
}

}  // namespace bole::desktop
