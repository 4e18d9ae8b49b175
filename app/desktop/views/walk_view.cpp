#include "views/walk_view.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>
#include <algorithm>

#include "look/theme.h"
#include "render/scene/view_camera.h"
#include "views/figure_picture.h"

namespace bole::desktop {

WalkView::WalkView(QWidget* parent) : QVTKOpenGLNativeWidget(parent), layers_(renderer_) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->AddRenderer(renderer_);
  follow_theme();
  setRenderWindow(window);
  vtkNew<vtkInteractorStyleTerrain> style;  // z stays up
  interactor()->SetInteractorStyle(style);
  eye_ = Eigen::Vector3d(renderer_->GetActiveCamera()->GetPosition());
}

void WalkView::changeEvent(QEvent* event) {
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) follow_theme();
}

void WalkView::follow_theme() {
  const bool dark = is_dark(palette());
  set_background(renderer_, dark);
  layers_.set_dark(dark);
  redraw();
}

void WalkView::clear() {
  layers_.clear();
  eye_ = Eigen::Vector3d(renderer_->GetActiveCamera()->GetPosition());
  redraw();
}

void WalkView::show_live(LiveMap& map, bool frame) {
  const bool follow = !camera_moved();
  layers_.show_live(map, frame);
  if (follow)
    look_at_all();
  else
    redraw();
}

void WalkView::show_survey(const Survey& survey, const Table* loops) {
  layers_.show_survey(survey, loops);
  look_at_all();
}

void WalkView::show_frame(const PlacedFrame& frame) {
  const bool first = !layers_.shows_frame() && layers_.drawn_points() == 0;
  layers_.show_frame(frame);
  if (first)
    look_at_all();
  else
    redraw();
}

bool WalkView::camera_moved() const {
  return (Eigen::Vector3d(renderer_->GetActiveCamera()->GetPosition()) - eye_).norm() > 1e-6;
}

void WalkView::look_at_all() {
  const auto [lo, hi] = layers_.extent();
  if (lo.x() > hi.x()) return redraw();
  const std::vector<Eigen::Vector3d> corners{{lo.x(), lo.y(), lo.z()}, {hi.x(), lo.y(), lo.z()},
                                             {lo.x(), hi.y(), lo.z()}, {hi.x(), hi.y(), lo.z()},
                                             {lo.x(), lo.y(), hi.z()}, {hi.x(), hi.y(), hi.z()}};
  auto* camera = renderer_->GetActiveCamera();
  render::aim_obliquely(camera, (lo + hi) / 2, hi - lo, static_cast<double>(width()) / std::max(1, height()), corners,
                        200, 40);
  eye_ = Eigen::Vector3d(camera->GetPosition());
  redraw();
}

void WalkView::showEvent(QShowEvent* event) {
  QVTKOpenGLNativeWidget::showEvent(event);
  if (!camera_moved()) look_at_all();
}

// Not before the window is there: VTK would make a context of its own. What is hidden is drawn when it is shown.
void WalkView::redraw() {
  if (!isValid() || !isVisible()) return;
  layers_.set_pixel_ratio(devicePixelRatioF());
  renderer_->ResetCameraClippingRange();
  renderWindow()->Render();
}

}  // namespace bole::desktop
