// How a frame of the 3-D view is drawn: as many points as there is time for, while the camera rests over those that the
// frames before have drawn; then legend, scale bar, numbers and drawings over it.
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <array>
#include <cmath>

#include "look/pixels.h"
#include "render/scene/eye_dome.h"
#include "views/scene_camera.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr std::size_t seen_at_rest = 4'000'000;  // points

}  // namespace

// Not before the window is there: VTK would make a context of its own.
void SceneView::redraw() {
  if (holds_ > 0)
    frame_wanted_ = true;
  else if (isValid())
    draw_now();
}

// The driver begins at once, beside what other views have to do.
void SceneView::draw_now() {
  renderWindow()->Render();
  if (auto* context = QOpenGLContext::currentContext()) context->functions()->glFlush();
}

// VTK draws frames of its own when a button is let go.
void SceneView::hold_frames() {
  if (holds_++ == 0) interactor()->EnableRenderOff();
}

void SceneView::let_frames() {
  if (--holds_ > 0) return;
  interactor()->EnableRenderOn();
  if (std::exchange(frame_wanted_, false)) redraw();
}

void SceneView::begin_motion() {
  still_eye_.clear();
  begin_interaction();
}

// Of the mouse: a click moves nothing.
void SceneView::begin_interaction() {
  moving_ = true;
  rest_.start(rest_ms);
}

// What the eye saw from another place does not fit any more.
void SceneView::follow_eye() {
  auto* camera = renderer_->GetActiveCamera();
  std::vector<double> now{camera->GetViewAngle(),
                          camera->GetParallelProjection() != 0 ? camera->GetParallelScale() : 0};
  for (const double* v : {camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp()})
    now.insert(now.end(), v, v + 3);
  for (const double v : {origin_.x(), origin_.y(), origin_.z()}) now.push_back(v);
  for (const int k : {0, 1}) now.push_back(renderWindow()->GetSize()[k]);
  if (now == last_eye_) return;
  last_eye_ = std::move(now);
  if (std::exchange(rendering_, false)) furniture_.hide_picture();
  QMetaObject::invokeMethod(this, &SceneView::eye_moved, Qt::QueuedConnection);
}

void SceneView::show_rendering(const ColorImage& picture) {
  const int* size = renderWindow()->GetSize();
  furniture_.show_picture(picture, size[0], size[1]);
  rendering_ = true;
  redraw();
}

void SceneView::hide_rendering() {
  if (!std::exchange(rendering_, false)) return;
  furniture_.hide_picture();
  redraw();
}

void SceneView::before_frame() {
  follow_eye();
  if (point_ratio_ != devicePixelRatioF()) size_points();  // the window went to another screen
  frame_start_ = std::chrono::steady_clock::now();
  const bool moves = moving_ && last_eye_ != still_eye_;
  thinned_ = timed_ = moves;
  const auto step = pace_.step();
  const FramePace::Budget at_rest{seen_at_rest, at_once_ ? seen_at_rest : step.fresh};
  const auto budget = moves ? pace_.next() : at_rest;
  // Each cloud has its share of the frame; the survey has what is left.
  const std::size_t layers = 1 + clouds_.drawn_clouds();
  const bool clouds_complete = clouds_.update(budget.points / layers, budget.fresh / layers);
  const auto left = [](std::size_t all, std::size_t taken) { return all - std::min(all, taken); };
  complete_ = layer_.update(renderer_, left(budget.points, clouds_.drawn()), left(budget.fresh, clouds_.fresh())) &&
              clouds_complete;
  renderer_->keep(!moves);
  renderer_->draw_at_most(at_once_ ? seen_at_rest : step.points);
  if (!moves) still_eye_ = last_eye_;
  map_.suit(2 * half_height_m(renderer_->GetActiveCamera()) / std::max(1, renderWindow()->GetSize()[1]));
  place_clipping_planes();
  furniture_.set_shadow({}, 0, 0);
  place_furniture();
}

// Points that come in move them a little, and what was drawn between others is of no use any more.
void SceneView::place_clipping_planes() {
  constexpr double slack_share = 0.1;  // of the depth; VTK leaves half of it to both sides
  auto* camera = renderer_->GetActiveCamera();
  const std::array before{camera->GetClippingRange()[0], camera->GetClippingRange()[1]};
  renderer_->ResetCameraClippingRange();
  const double* now = camera->GetClippingRange();
  const double slack_m = slack_share * (now[1] - now[0]);
  if (last_eye_ == clipped_eye_ && std::abs(now[0] - before[0]) < slack_m && std::abs(now[1] - before[1]) < slack_m)
    camera->SetClippingRange(before.data());
  clipped_eye_ = last_eye_;
}

void SceneView::after_frame() {
  complete_ = complete_ && renderer_->whole();
  drawing_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count();
  frame_due_ = thinned_ || !complete_;
  if (frame_due_) return rest_.start(thinned_ ? rest_ms : 0);
  if (!settings_.eye_dome || rendering_ || awaited() > 0) return;
  const int* size = renderWindow()->GetSize();
  render::EyeDomeOptions shading;
  shading.radius_px = 1.6 * devicePixelRatioF();
  furniture_.set_shadow(render::eye_dome_shadow(render::window_depths_m(renderWindow(), renderer_->GetActiveCamera()),
                                                size[0], size[1], shading),
                        size[0], size[1]);
}

// The picture is on the screen: all that a frame costs has been paid.
void SceneView::frame_shown() {
  if (!std::exchange(timed_, false)) return;
  pace_.note(std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count(),
             layer_.drawn() + clouds_.drawn(), layer_.fresh() + clouds_.fresh(), !complete_);
}

double SceneView::draw_moving_frame() {
  begin_motion();
  renderWindow()->Render();
  renderWindow()->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count();
}

bool SceneView::north_known() const {
  const Axes axes = survey_.points ? survey_.points->axes : Axes::unknown;
  return axes == Axes::plot || axes == Axes::global || map();
}

void SceneView::place_furniture() {
  render::ViewFurniture f;
  f.width_mm = width() * mm_per_px;
  f.height_mm = height() * mm_per_px;
  if (settings_.legend && survey_.points && !survey_.points->empty() && !rendering_) f.paint = layer_.paint();
  if (settings_.legend && !rendering_) {
    f.clouds = clouds_.keys();
    f.clouds_paint = clouds_.legend(layer_.paint());
  }
  auto* camera = renderer_->GetActiveCamera();
  const double half_m = half_height_m(camera);
  if (settings_.scale_bar && has_survey() && half_m > 0) f.mm_per_metre = f.height_mm / 2 / half_m;
  f.perspective = camera->GetParallelProjection() == 0;
  f.grid_step_m = grid_step_m_;
  f.contour_step_m = terrain_.contour_step_m();
  f.north_rad = north_on_screen_rad(camera, north());
  f.north = settings_.north && north_known();
  for (const auto& fact : facts_) f.notes.push_back(fact.toStdString());
  const auto view = pick_view();
  const double mm = f.width_mm / std::max(1, renderWindow()->GetSize()[0]);  // a picture may have more pixels
  add_trees(f, view, mm);
  SceneDrawing mark;
  if (picked_) mark.marks = {picked_->position()};
  add_to(f, mark, view, mm);
  for (const auto& [layer, drawings] : drawings_)
    for (const auto& drawing : drawings) add_to(f, drawing, view, mm);
  furniture_.show(f, 1 / mm);
}

}  // namespace bole::desktop
