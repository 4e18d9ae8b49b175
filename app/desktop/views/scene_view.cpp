#include "views/scene_view.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <QGuiApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/draw/color.h"
#include "render/scene/actors.h"
#include "render/scene/stem_shapes.h"
#include "render/scene/view_camera.h"
#include "views/scene_overlay.h"

namespace bole::desktop {
namespace {

constexpr double target_s = 0.036;  // of a frame while the camera moves: 20 frames/s with time left for the window
constexpr std::size_t least_budget = 60'000, first_budget = 400'000, most_budget = 2'500'000;
constexpr std::size_t rest_budget = 4'000'000;                          // points of a view at rest
constexpr std::size_t fresh_moving = 150'000, fresh_resting = 500'000;  // points prepared for one frame
constexpr int rest_ms = 150;
constexpr double highlight_m = 0.12;  // by how much the ring of the selected tree stands off its bark
constexpr double pick_reach_px = 6, click_px = 4;

}  // namespace

SceneView::SceneView(Selection& selection, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      selection_(selection),
      overlay_(new SceneOverlay(this)),
      moving_budget_(first_budget) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->AddRenderer(renderer_);
  renderer_->SetBackground(1, 1, 1);
  setRenderWindow(window);
  vtkNew<vtkInteractorStyleTerrain> style;  // z stays up
  interactor()->SetInteractorStyle(style);
  style->AddObserver(vtkCommand::StartInteractionEvent, this, &SceneView::begin_motion);
  renderer_->AddObserver(vtkCommand::StartEvent, this, &SceneView::before_frame);
  renderer_->AddObserver(vtkCommand::EndEvent, this, &SceneView::after_frame);
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, [this] {
    moving_ = QGuiApplication::mouseButtons() != Qt::NoButton && moving_;
    if (moving_) return rest_.start(rest_ms);
    redraw();
  });
  connect(&selection_, &Selection::changed, this, [this] {
    draw_highlight();
    redraw();
  });
}

void SceneView::show_survey(const Survey& survey) {
  const bool first = !has_survey();
  survey_ = survey;
  picked_.reset();
  facts_.clear();
  rebuild();
  if (first)
    reset_camera();
  else
    redraw();  // an edit leaves the camera where it is
}

void SceneView::color_by(const std::string& array) {
  color_array_ = array;
  if (survey_.points) layer_.set_paint(paint_by(*survey_.points, color_array_));
  redraw();
}

std::vector<std::string> SceneView::colorable() const {
  return survey_.points ? paintable_arrays(*survey_.points) : std::vector<std::string>();
}

void SceneView::set_filter(const PointFilter& filter) {
  filter_ = filter;
  layer_.set_filter(filter);
  redraw();
}

int SceneView::actor_count() { return renderer_->GetActors()->GetNumberOfItems(); }

void SceneView::rebuild() {
  layer_.show(nullptr, nullptr, origin_);
  renderer_->RemoveAllViewProps();
  highlight_ = nullptr;
  origin_ = survey_.points ? survey_.points->origin : Eigen::Vector3d::Zero().eval();
  shapes_.clear();
  if (survey_.points) {
    layer_.set_paint(paint_by(*survey_.points, color_array_));
    layer_.set_filter(filter_);
    layer_.show(survey_.points, survey_.index, origin_);
  }
  if (survey_.stems && survey_.stems->rows() > 0) {
    shapes_ = stem_shapes(*survey_.stems, survey_.sections.get());
    renderer_->AddActor(stems_actor(shapes_, origin_, true));
    renderer_->AddActor(breast_height_actor(shapes_, origin_, 0.04));
  }
  if (survey_.walk && survey_.walk->poses.size() > 1)
    renderer_->AddActor(path_actor(*survey_.walk, origin_, 0.05, hex(0x1f6f9f)));
  draw_highlight();
}

void SceneView::draw_highlight() {
  if (highlight_) renderer_->RemoveActor(highlight_);
  highlight_ = nullptr;
  if (!selection_.tree()) return;
  std::vector<StemShape> shape;
  std::ranges::copy_if(shapes_, std::back_inserter(shape),
                       [&](const auto& s) { return s.tree_id == selection_.tree(); });
  if (shape.empty()) return;
  highlight_ = breast_height_actor(shape, origin_, highlight_m);
  highlight_->GetMapper()->ScalarVisibilityOff();
  highlight_->GetProperty()->SetColor(0.0, 0.45, 0.9);
  renderer_->AddActor(highlight_);
}

// Not before the window is there: VTK would make a context of its own.
void SceneView::redraw() {
  if (isValid()) renderWindow()->Render();
}

void SceneView::begin_motion() {
  moving_ = true;
  rest_.start(rest_ms);
}

void SceneView::before_frame() {
  frame_start_ = std::chrono::steady_clock::now();
  complete_ = layer_.update(renderer_, moving_ ? moving_budget_ : rest_budget, moving_ ? fresh_moving : fresh_resting);
  renderer_->ResetCameraClippingRange();
}

void SceneView::after_frame() {
  if (moving_) {
    renderWindow()->WaitForCompletion();
    last_frame_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count();
    // Half way to what this frame says: single slow frames (another program's work) do not count much.
    const double better = static_cast<double>(moving_budget_) * std::clamp(target_s / last_frame_s_, 0.5, 1.3);
    moving_budget_ = std::clamp(static_cast<std::size_t>(0.5 * (better + static_cast<double>(moving_budget_))),
                                least_budget, most_budget);
    rest_.start(rest_ms);
  } else if (!complete_) {
    rest_.start(0);
  }
  place_furniture();
}

double SceneView::frame_target_s() const { return target_s; }

double SceneView::draw_moving_frame() {
  moving_ = true;
  renderWindow()->Render();
  return last_frame_s_;
}

void SceneView::place_furniture() {
  ViewFurniture f;
  if (survey_.points && !survey_.points->empty()) f.paint = layer_.paint();
  auto* camera = renderer_->GetActiveCamera();
  const double half_px = height() / 2.0;
  const double half_m = camera->GetParallelProjection()
                            ? camera->GetParallelScale()
                            : camera->GetDistance() * std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  if (has_survey() && half_m > 0) f.mm_per_metre = half_px * SceneOverlay::mm_per_px / half_m;
  f.perspective = camera->GetParallelProjection() == 0;
  const Eigen::Vector3d view(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  const Eigen::Vector3d right = view.cross(up).normalized(), screen_up = right.cross(view);
  f.north_rad = -std::atan2(right.y(), screen_up.y());
  const Axes axes = survey_.points ? survey_.points->axes : Axes::unknown;
  f.north_known = axes == Axes::plot || axes == Axes::global;
  for (const auto& fact : facts_) f.notes.push_back(fact.toStdString());
  if (picked_ && survey_.points && *picked_ < survey_.points->size())
    if (const auto at = on_screen(pick_view(), survey_.points->position(*picked_)))
      f.mark_mm = Eigen::Vector2d(at->px.x() / devicePixelRatioF(), height() - at->px.y() / devicePixelRatioF()) *
                  SceneOverlay::mm_per_px;
  overlay_->show_furniture(std::move(f));
}

void SceneView::reset_camera() { look_along(Eigen::Vector3d(0.5, 1.0, -0.55), Eigen::Vector3d::UnitZ()); }

void SceneView::look_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  auto* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d from = -direction.normalized();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(from.x(), from.y(), from.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  if (survey_.index && !survey_.index->nodes().empty()) {
    // The root's first points are an even sample: strays far away do not set the scale.
    std::vector<double> axis[3];
    for (const auto i : survey_.index->points(survey_.index->nodes().front()))
      for (int k = 0; k < 3; ++k) axis[k].push_back(static_cast<double>(survey_.points->positions()[i][k]));
    double bounds[6];
    for (int k = 0; k < 3; ++k) {
      std::ranges::sort(axis[k]);
      bounds[2 * k] = axis[k][axis[k].size() / 100];
      bounds[2 * k + 1] = axis[k][axis[k].size() - 1 - axis[k].size() / 100];
    }
    renderer_->ResetCamera(bounds);
  } else {
    renderer_->ResetCamera();
  }
  redraw();
}

void SceneView::set_parallel(bool on) {
  auto* camera = renderer_->GetActiveCamera();
  if (on) camera->SetParallelScale(camera->GetDistance() * std::tan(camera->GetViewAngle() * std::numbers::pi / 360));
  camera->SetParallelProjection(on);
  redraw();
}

bool SceneView::parallel() const { return renderer_->GetActiveCamera()->GetParallelProjection() != 0; }

void SceneView::zoom_to_tree(std::int64_t id) {
  const auto it = std::ranges::find(shapes_, id, &StemShape::tree_id);
  if (it == shapes_.end()) return;
  constexpr double distance_m = 7;
  auto* camera = renderer_->GetActiveCamera();
  Eigen::Vector3d from = -Eigen::Vector3d(camera->GetDirectionOfProjection());
  from.z() = std::clamp(from.z(), 0.15, 0.6);  // a stem is judged from the side
  const Eigen::Vector3d target = it->breast_height - origin_,
                        eye = target + std::min(distance_m, std::max(camera->GetDistance(), 3.0)) * from.normalized();
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0, 0, 1);
  camera->SetParallelScale(3);
  redraw();
}

PickView SceneView::pick_view() {
  const int* size = renderer_->GetSize();
  const double aspect = static_cast<double>(std::max(size[0], 1)) / std::max(size[1], 1);
  return {view_matrix(renderer_->GetActiveCamera(), aspect), origin_, static_cast<double>(size[0]),
          static_cast<double>(size[1])};
}

Eigen::Vector2d SceneView::to_pixels(const QPoint& at) const {
  return Eigen::Vector2d(at.x(), height() - at.y()) * devicePixelRatioF();
}

void SceneView::pick(const QPoint& at) {
  const auto view = pick_view();
  const auto px = to_pixels(at);
  picked_.reset();
  facts_.clear();
  std::optional<std::int64_t> tree;
  if (survey_.points) {
    picked_ = pick_point(view, *survey_.points, layer_.drawn_points(), px, pick_reach_px * devicePixelRatioF());
    if (picked_) {
      for (const auto& line : describe_point(*survey_.points, *picked_)) facts_ << QString::fromStdString(line);
      if (survey_.points->has(arrays::tree_id))
        if (const auto id = survey_.points->values<std::int32_t>(arrays::tree_id)[*picked_]; id > 0) tree = id;
    }
  }
  if (const auto stem = pick_stem(view, shapes_, px, 2 * devicePixelRatioF())) {
    // A stem hides what lies behind it, and is hidden by points before it.
    const auto point = picked_ ? on_screen(view, survey_.points->position(*picked_)) : std::nullopt;
    if (!tree && (!point || stem->depth <= point->depth)) tree = stem->tree_id;
  }
  if (tree && survey_.row_of(*tree)) selection_.select(tree);
  Q_EMIT point_picked(facts_);
  redraw();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->pos();
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  if (event->button() == Qt::LeftButton && (event->pos() - pressed_at_).manhattanLength() <= click_px && has_survey())
    pick(event->pos());
}

// Towards what lies under the cursor, at the depth of the focal point.
void SceneView::wheelEvent(QWheelEvent* event) {
  auto* camera = renderer_->GetActiveCamera();
  const double factor = std::pow(1.2, event->angleDelta().y() / 120.0);
  const auto view = pick_view();
  const Eigen::Vector2d px = to_pixels(event->position().toPoint());
  const Eigen::Vector2d off(2 * px.x() / view.width_px - 1, 2 * px.y() / view.height_px - 1);
  const double half_m = camera->GetParallelProjection()
                            ? camera->GetParallelScale()
                            : camera->GetDistance() * std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  const Eigen::Vector3d right = ahead.cross(up).normalized();
  const Eigen::Vector3d shift =
      (1 - 1 / factor) * half_m * (off.x() * view.width_px / view.height_px * right + off.y() * right.cross(ahead));
  const Eigen::Vector3d target = Eigen::Vector3d(camera->GetFocalPoint()) + shift;
  const Eigen::Vector3d eye = target - camera->GetDistance() / factor * ahead;
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  camera->SetParallelScale(camera->GetParallelScale() / factor);
  begin_motion();
  redraw();
  event->accept();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  overlay_->setGeometry(rect());
  overlay_->raise();
}

}  // namespace bole::desktop
