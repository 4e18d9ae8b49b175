#include "views/scene_view.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <QGuiApplication>
#include <QMouseEvent>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "look/pixels.h"
#include "render/draw/color.h"
#include "render/draw/color_maps.h"
#include "render/scene/actors.h"
#include "render/scene/eye_dome.h"
#include "render/scene/stem_shapes.h"
#include "render/scene/view_camera.h"
#include "views/clip_handles.h"
#include "views/figure_picture.h"
#include "views/map_style.h"
#include "views/scene_camera.h"

namespace bole::desktop {
namespace {

constexpr double target_s = 0.042;  // of a frame while the camera moves, until it is on the screen: above 20 frames/s
constexpr FramePace::Budget at_rest{4'000'000, 500'000};
constexpr int rest_ms = 150;
constexpr double highlight_m = 0.12;  // by how much the ring of the selected tree stands off its bark

}  // namespace

SceneView::SceneView(Selection& selection, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), selection_(selection), cameras_(renderer_), pace_(target_s) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetNumberOfLayers(2);
  window->AddRenderer(renderer_);
  window->AddRenderer(furniture_.renderer());
  setRenderWindow(window);
  follow_theme();
  setMouseTracking(true);
  style_ = vtkSmartPointer<MapStyle>::New();
  interactor()->SetInteractorStyle(style_);
  style_->AddObserver(vtkCommand::StartInteractionEvent, this, &SceneView::begin_motion);
  renderer_->AddObserver(vtkCommand::StartEvent, this, &SceneView::before_frame);
  renderer_->AddObserver(vtkCommand::EndEvent, this, &SceneView::after_frame);
  clip_handles_ = std::make_unique<ClipHandles>(interactor(), renderer_, [this](const render::ClipBox& box) {
    settings_.clip = box;
    layer_.set_clip(box);
    clip_stems();
    begin_motion();
    Q_EMIT settings_changed();
  });
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, [this] {
    moving_ = QGuiApplication::mouseButtons() != Qt::NoButton && moving_;
    if (moving_) return rest_.start(rest_ms);
    redraw();
  });
  connect(this, &QOpenGLWidget::frameSwapped, this, &SceneView::frame_shown);
  connect(&selection_, &Selection::changed, this, [this] {
    draw_highlight();
    redraw();
  });
  connect(&selection_, &Selection::view_changed, this, [this] {
    draw_cameras();
    redraw();
  });
}

SceneView::~SceneView() = default;

void SceneView::changeEvent(QEvent* event) {
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) follow_theme();
}

// Figures of the report are made without the window and stay white.
void SceneView::follow_theme() {
  look_ = screen_look(palette());
  set_background(renderer_, look_.dark);
  furniture_.set_look(look_);
  if (has_survey())
    rebuild();
  else
    draw_cameras();
  redraw();
}

void SceneView::show_survey(const Survey& survey) {
  const bool first = !has_survey(), first_points = survey.points && (first || !survey_.points);
  survey_ = survey;
  picked_.reset();
  facts_.clear();
  if (first) {  // ranges and boxes are those of the survey before
    settings_.clip.reset();
    settings_.filter = {};
    settings_.color_range.reset();
    show_clip_handles(false);
    layer_.set_clip({});
    if (std::exchange(photo_by_itself_, false)) settings_.color = ViewSettings().color;
  }
  if (first_points && (survey.poses || survey.traits) && settings_.color == ViewSettings().color &&
      render::paint_by(*survey.points, "photo").kind == render::PointPaint::Kind::photo) {
    settings_.color = "photo";
    photo_by_itself_ = true;
  }
  rebuild();
  follow_index();
  if (first) {
    begin_motion();  // something is seen at once; the rest follows
    reset_camera();
  } else {
    redraw();  // an edit leaves the camera where it is
  }
  Q_EMIT settings_changed();
}

// Until the octree is built the points are a sample of the cloud.
void SceneView::follow_index() {
  if (!survey_.index || survey_.index->complete()) return;
  connect(survey_.index.get(), &PointIndex::built, this, [this, index = survey_.index.get()] {
    if (survey_.index.get() != index) return;
    layer_.show(survey_.points, survey_.index->octree(), origin_);
    redraw();
    Q_EMIT index_built();
  });
  if (survey_.index->complete()) layer_.show(survey_.points, survey_.index->octree(), origin_);  // in between
}

void SceneView::set_settings(const ViewSettings& settings) {
  const auto before = std::exchange(settings_, settings);
  if (before.color != settings_.color) photo_by_itself_ = false;
  const auto same = [](const std::optional<render::Interval>& a, const std::optional<render::Interval>& b) {
    return a.has_value() == b.has_value() && (!a || (a->lo == b->lo && a->hi == b->hi));
  };
  if (before.color != settings_.color || before.color_map != settings_.color_map ||
      !same(before.color_range, settings_.color_range))
    repaint_points();
  if (!same(before.filter.height, settings_.filter.height)) layer_.set_filter(settings_.filter);
  layer_.set_clip(settings_.clip);
  clip_stems();
  layer_.set_point_size(settings_.point_size_px);
  if (clip_handles_->shown()) show_clip_handles(settings_.clip.has_value());
  if (before.grid != settings_.grid) rebuild_grid();
  redraw();
}

void SceneView::color_by(const std::string& array) {
  auto settings = settings_;
  settings.color = array;
  settings.color_range.reset();
  set_settings(settings);
  Q_EMIT settings_changed();
}

std::vector<std::string> SceneView::colorable() const {
  return survey_.points ? render::paintable_arrays(*survey_.points) : std::vector<std::string>();
}

void SceneView::set_filter(const render::PointFilter& filter) {
  auto settings = settings_;
  settings.filter = filter;
  set_settings(settings);
  Q_EMIT settings_changed();
}

void SceneView::repaint_points() {
  if (!survey_.points) return;
  auto paint = render::paint_by(*survey_.points, settings_.color);
  if (settings_.color_range && paint.kind == render::PointPaint::Kind::map) paint.range = *settings_.color_range;
  if (const auto* map = render::color_map_named(settings_.color_map);
      map && paint.kind == render::PointPaint::Kind::map)
    paint.map = map;
  layer_.set_paint(std::move(paint));
}

void SceneView::show_clip_handles(bool on) {
  if (on && settings_.clip)
    clip_handles_->show(*settings_.clip, origin_);
  else
    clip_handles_->hide();
  redraw();
}

bool SceneView::clip_handles_shown() const { return clip_handles_->shown(); }

// The first node of the index is an even sample of the cloud.
std::vector<double> SceneView::sorted_sample(int axis) const {
  std::vector<double> values;
  const auto octree = survey_.index ? survey_.index->octree() : nullptr;
  if (!octree || octree->nodes().empty()) return values;
  const auto* heights = survey_.points->has(arrays::height_above_ground)
                            ? std::get_if<std::vector<float>>(&survey_.points->column(arrays::height_above_ground.name))
                            : nullptr;
  for (const auto i : octree->points(octree->nodes().front())) {
    const double v = axis < 3             ? survey_.points->position(i)[axis]
                     : heights != nullptr ? static_cast<double>((*heights)[i])
                                          : survey_.points->position(i).z();
    if (std::isfinite(v)) values.push_back(v);
  }
  std::ranges::sort(values);
  return values;
}

void SceneView::measure_extent() {
  whole_ = {};
  heights_ = {};
  extent_known_ = false;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto v = sorted_sample(axis); !v.empty()) {
      extent_known_ = true;
      whole_.lo[axis] = v[v.size() / 100];
      whole_.hi[axis] = v[v.size() - 1 - v.size() / 100];
    }
  if (const auto v = sorted_sample(3); !v.empty()) heights_ = {v[v.size() / 1000], v[v.size() - 1 - v.size() / 1000]};
  if (extent_known_ || !survey_.plants || survey_.plants->rows() == 0) return;
  // Rows without a cloud.
  for (const auto& [axis, name] : {std::pair{0, "x_m"}, {1, "y_m"}}) {
    const auto v = survey_.plants->numbers(name);
    whole_.lo[axis] = *std::ranges::min_element(v);
    whole_.hi[axis] = *std::ranges::max_element(v);
  }
  extent_known_ = whole_.lo.allFinite() && whole_.hi.allFinite();
}

render::ClipBox SceneView::everything() const {
  if (!survey_.points || survey_.points->empty()) return whole_;
  Eigen::Vector3f lo = survey_.points->positions().front(), hi = lo;
  for (const auto& p : survey_.points->positions())
    if (p.allFinite()) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  return {survey_.points->origin + lo.cast<double>(), survey_.points->origin + hi.cast<double>()};
}

int SceneView::actor_count() {
  return renderer_->GetActors()->GetNumberOfItems() - static_cast<int>(layer_.actors()) +
         (survey_.points && !survey_.points->empty() ? 1 : 0);
}

void SceneView::rebuild() {
  layer_.show(nullptr, nullptr, origin_);
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
  const auto add = [this](vtkSmartPointer<vtkActor> actor) {
    renderer_->AddActor(actor);
    actors_.push_back(std::move(actor));
  };
  measure_extent();
  origin_ = survey_.points ? survey_.points->origin : whole_.lo;
  shapes_.clear();
  if (survey_.points) {
    repaint_points();
    layer_.set_filter(settings_.filter);
    layer_.show(survey_.points, survey_.index ? survey_.index->octree() : nullptr, origin_);
  }
  // Plants of rows have places only.
  if (survey_.stems && survey_.stems->rows() > 0 && survey_.stems->has("dbh_cm") && survey_.stems->has("z_m")) {
    shapes_ = render::stem_shapes(*survey_.stems, survey_.sections.get());
    add(render::stems_actor(shapes_, origin_, true));
    add(render::breast_height_actor(shapes_, origin_, 0.04));
  }
  if (survey_.walk && survey_.walk->poses.size() > 1)
    add(render::path_actor(*survey_.walk, origin_, 0.05,
                           look_.dark ? render::on_dark(render::ink::path) : render::hex(0x1f6f9f)));
  take_trees();
  clip_stems();
  rebuild_grid();
  draw_highlight();
  draw_cameras();
}

void SceneView::set_cameras(std::vector<render::CameraShape> cameras) {
  const bool first = cameras_.shapes().empty() && !has_survey();
  cameras_.set(std::move(cameras));
  draw_cameras();
  if (first)
    reset_camera();
  else
    redraw();
}

void SceneView::show_picture(std::size_t view, const ColorImage& picture) {
  cameras_.set_picture(view, picture);
  draw_cameras();
  redraw();
}

void SceneView::draw_cameras() {
  const double extent_m = extent_known_ ? (whole_.hi - whole_.lo).norm() : 0;
  cameras_.draw(origin_, extent_m, selection_.view(), look_.dark, devicePixelRatioF());
}

// The cloud and the cameras about it.
std::optional<render::ClipBox> SceneView::all_of_it() const {
  auto box = cameras_.box();
  if (!extent_known_) return box;
  if (!box) return whole_;
  return render::ClipBox{whole_.lo.cwiseMin(box->lo), whole_.hi.cwiseMax(box->hi)};
}

void SceneView::rebuild_grid() {
  if (grid_) renderer_->RemoveActor(grid_);
  grid_ = nullptr;
  grid_step_m_ = 0;
  if (!settings_.grid || !survey_.points) return;
  const auto box = whole();
  grid_step_m_ = render::nice_step((box.hi - box.lo).head<2>().maxCoeff(), 8);
  grid_ = render::grid_actor({box.lo.x(), box.hi.x()}, {box.lo.y(), box.hi.y()}, box.lo.z(), grid_step_m_, origin_,
                             look_.dark ? render::hex(0x4f585e) : render::hex(0x8d99a1));
  renderer_->AddActor(grid_);
}

void SceneView::draw_highlight() {
  if (highlight_) renderer_->RemoveActor(highlight_);
  highlight_ = nullptr;
  if (!selection_.tree()) return;
  std::vector<render::StemShape> shape;
  std::ranges::copy_if(shapes_, std::back_inserter(shape),
                       [&](const auto& s) { return s.tree_id == selection_.tree(); });
  if (shape.empty()) return;
  highlight_ = render::breast_height_actor(shape, origin_, highlight_m);
  highlight_->GetMapper()->ScalarVisibilityOff();
  const render::Color blue = look_.dark ? render::hex(0x5ab0ff) : render::hex(0x0073e6);
  highlight_->GetProperty()->SetColor(blue.r, blue.g, blue.b);
  renderer_->AddActor(highlight_);
}

void SceneView::set_drawings(const std::string& layer, std::vector<SceneDrawing> drawings) {
  if (drawings.empty() && !drawings_.contains(layer)) return;
  if (dragged_ && dragged_->layer == layer) {
    const auto same = std::ranges::find(drawings, dragged_->id, &SceneDrawing::id);
    if (same == drawings.end() || same->grips.size() <= dragged_->grip)
      dragged_.reset();
    else
      dragged_->drawing = static_cast<std::size_t>(same - drawings.begin());
  }
  drawings_[layer] = std::move(drawings);
  redraw();
}

// Not before the window is there: VTK would make a context of its own.
void SceneView::redraw() {
  if (isValid()) renderWindow()->Render();
}

void SceneView::begin_motion() {
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

std::optional<SceneEye> SceneView::eye() {
  if (parallel()) return {};
  auto* camera = renderer_->GetActiveCamera();
  const int* size = renderWindow()->GetSize();
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection()), up(camera->GetViewUp());
  SceneEye eye;
  eye.T_world_camera.linear().col(0) = ahead.cross(up).normalized();
  eye.T_world_camera.linear().col(1) = ahead.cross(eye.T_world_camera.linear().col(0));
  eye.T_world_camera.linear().col(2) = ahead;
  eye.T_world_camera.translation() = Eigen::Vector3d(camera->GetPosition()) + origin_;
  eye.tan_half_height = std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  eye.width_px = std::max(1, size[0]);
  eye.height_px = std::max(1, size[1]);
  return eye;
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
  frame_start_ = std::chrono::steady_clock::now();
  timed_ = moving_;
  const auto budget = moving_ ? pace_.next() : at_rest;
  complete_ = layer_.update(renderer_, budget.points, budget.fresh);
  renderer_->ResetCameraClippingRange();
  furniture_.set_shadow({}, 0, 0);
  place_furniture();
}

void SceneView::after_frame() {
  if (moving_) return rest_.start(rest_ms);
  if (!complete_) return rest_.start(0);
  if (!settings_.eye_dome || rendering_) return;
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
  pace_.note(std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count(), layer_.drawn(),
             layer_.fresh(), !complete_);
}

double SceneView::frame_target_s() const { return target_s; }

double SceneView::draw_moving_frame() {
  moving_ = true;
  renderWindow()->Render();
  renderWindow()->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - frame_start_).count();
}

void SceneView::place_furniture() {
  render::ViewFurniture f;
  f.width_mm = width() * mm_per_px;
  f.height_mm = height() * mm_per_px;
  if (settings_.legend && survey_.points && !survey_.points->empty() && !rendering_) f.paint = layer_.paint();
  auto* camera = renderer_->GetActiveCamera();
  const double half_m = half_height_m(camera);
  if (settings_.scale_bar && has_survey() && half_m > 0) f.mm_per_metre = f.height_mm / 2 / half_m;
  f.perspective = camera->GetParallelProjection() == 0;
  f.grid_step_m = grid_step_m_;
  f.north_rad = north_on_screen_rad(camera);
  const Axes axes = survey_.points ? survey_.points->axes : Axes::unknown;
  f.north = settings_.north && (axes == Axes::plot || axes == Axes::global);
  for (const auto& fact : facts_) f.notes.push_back(fact.toStdString());
  const auto view = pick_view();
  const double mm = f.width_mm / std::max(1, renderWindow()->GetSize()[0]);  // a picture may have more pixels
  add_trees(f, view, mm);
  SceneDrawing mark;
  if (picked_ && survey_.points && *picked_ < survey_.points->size()) mark.marks = {survey_.points->position(*picked_)};
  add_to(f, mark, view, mm);
  for (const auto& [layer, drawings] : drawings_)
    for (const auto& drawing : drawings) add_to(f, drawing, view, mm);
  furniture_.show(f, 1 / mm);
}

void SceneView::reset_camera() { look_along(Eigen::Vector3d(0.5, 1.0, -0.55), Eigen::Vector3d::UnitZ()); }

void SceneView::look_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  auto* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d from = -direction.normalized();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(from.x(), from.y(), from.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  if (const auto box = all_of_it()) {
    // Strays far away do not set the scale.
    fit_box(camera, box->lo - origin_, box->hi - origin_, static_cast<double>(width()) / std::max(1, height()));
    renderer_->ResetCameraClippingRange();
  } else {
    renderer_->ResetCamera();
  }
  eye_ = Eigen::Vector3d(camera->GetPosition());
  redraw();
}

bool SceneView::camera_moved() const {
  return !Eigen::Vector3d(renderer_->GetActiveCamera()->GetPosition()).isApprox(eye_, 1e-9);
}

void SceneView::set_parallel(bool on) {
  desktop::set_parallel(renderer_->GetActiveCamera(), on);
  redraw();
}

bool SceneView::parallel() const { return renderer_->GetActiveCamera()->GetParallelProjection() != 0; }

Eigen::Vector3d SceneView::centre() const {
  return Eigen::Vector3d(renderer_->GetActiveCamera()->GetFocalPoint()) + origin_;
}

Eigen::Vector3d SceneView::stem_place_of(std::int64_t tree) const {
  const auto it = std::ranges::find(shapes_, tree, &render::StemShape::tree_id);
  return it == shapes_.end() ? centre() : it->breast_height;
}

void SceneView::zoom_to(const Eigen::Vector3d& place) {
  if (flat())
    centre_on(renderer_->GetActiveCamera(), place - origin_);
  else
    approach(renderer_->GetActiveCamera(), place - origin_, approach_m);
  redraw();
}

render::PickView SceneView::pick_view() {
  const int* size = renderer_->GetSize();
  const double aspect = static_cast<double>(std::max(size[0], 1)) / std::max(size[1], 1);
  return {render::view_matrix(renderer_->GetActiveCamera(), aspect), origin_, static_cast<double>(size[0]),
          static_cast<double>(size[1])};
}

Eigen::Vector2d SceneView::to_pixels(const QPoint& at) const {
  return Eigen::Vector2d(at.x(), height() - at.y()) * devicePixelRatioF();
}

QPoint SceneView::place_of(const Eigen::Vector3d& world) {
  const auto at = render::on_screen(pick_view(), world);
  if (!at) return {-1, -1};
  const Eigen::Vector2d px = at->px / devicePixelRatioF();
  return {static_cast<int>(std::lround(px.x())), static_cast<int>(std::lround(height() - px.y()))};
}

}  // namespace bole::desktop
