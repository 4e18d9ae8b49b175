#include "views/scene_view.h"

#include <vtkActor.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QGuiApplication>
#include <algorithm>

#include "look/theme.h"
#include "render/draw/color_maps.h"
#include "views/clip_handles.h"
#include "views/figure_picture.h"
#include "views/map_style.h"

namespace bole::desktop {
namespace {

constexpr double target_s = 0.042;  // of a frame while the camera moves, until it is on the screen: above 20 frames/s

}  // namespace

SceneView::SceneView(Selection& selection, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      selection_(selection),
      clouds_(renderer_),
      cameras_(renderer_),
      map_(renderer_),
      terrain_(renderer_),
      pace_(target_s) {
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
  style_->AddObserver(vtkCommand::StartInteractionEvent, this, &SceneView::begin_interaction);
  interactor()->AddObserver(vtkCommand::RenderEvent, this, &SceneView::note_frame_of_vtk);
  renderer_->AddObserver(vtkCommand::StartEvent, this, &SceneView::before_frame);
  renderer_->AddObserver(vtkCommand::EndEvent, this, &SceneView::after_frame);
  clip_handles_ = std::make_unique<ClipHandles>(interactor(), renderer_, [this](const render::ClipBox& box) {
    settings_.clip = box;
    layer_.set_clip(box);
    clouds_.set_clip(box);
    clip_solids();
    begin_motion();
    Q_EMIT settings_changed();
  });
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, [this] {
    moving_ = QGuiApplication::mouseButtons() != Qt::NoButton && moving_;
    if (moving_) return rest_.start(rest_ms);
    if (std::exchange(frame_due_, false)) redraw();  // after a click that moved nothing there is no need
  });
  connect(this, &QOpenGLWidget::frameSwapped, this, &SceneView::frame_shown);
  connect(&clouds_, &CloudLayers::arrived, this, &SceneView::take_arrivals);
  connect(&clouds_, &CloudLayers::index_built, this, [this] {
    redraw();
    Q_EMIT clouds_changed();
  });
  connect(&selection_, &Selection::changed, this, [this] {
    draw_highlight();
    redraw();
  });
  connect(&selection_, &Selection::telling, this, [this] {
    hold_frames();
    click_.reset();  // its frame is that of what it selects
  });
  connect(&selection_, &Selection::told, this, &SceneView::let_frames);
  connect(&selection_, &Selection::view_changed, this, [this] {
    draw_cameras();
    redraw();
  });
}

SceneView::~SceneView() = default;

void SceneView::changeEvent(QEvent* event) {
  QVTKOpenGLNativeWidget::changeEvent(event);
  // A change of style and palette comes in several events.
  if (event->type() == QEvent::PaletteChange && is_dark(palette()) != look_.dark) follow_theme();
}

// Figures of the report are made without the window and stay white.
void SceneView::follow_theme() {
  look_ = screen_look(palette());
  set_background(renderer_, look_.dark);
  furniture_.set_look(look_);
  draw_in_theme();
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

void SceneView::show_points() {
  if (survey_.index && survey_.index->disk())
    layer_.show(survey_.index->disk(), origin_);
  else
    layer_.show(survey_.points, survey_.index ? survey_.index->octree() : nullptr, origin_);
}

// A frame of all points at rest takes long: most of the time is left to those who fetch more of them.
void SceneView::take_arrivals() {
  constexpr double waits_per_frame = 3;
  frame_due_ = true;
  if (!moving_ && !rest_.isActive()) rest_.start(static_cast<int>(1000 * waits_per_frame * drawing_s_));
}

// Until the octree is built the points are a sample of the cloud; those on disk arrive by and by.
void SceneView::follow_index() {
  disconnect(arrivals_);
  if (!survey_.index) return;
  if (const auto& disk = survey_.index->disk())
    arrivals_ = connect(disk.get(), &DiskPoints::arrived, this, &SceneView::take_arrivals);
  if (survey_.index->complete()) return;
  connect(survey_.index.get(), &PointIndex::built, this, [this, index = survey_.index.get()] {
    if (survey_.index.get() != index) return;
    show_points();
    redraw();
    Q_EMIT index_built();
  });
  if (survey_.index->complete()) show_points();  // in between
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
  dress_clouds();
  if (clip_handles_->shown()) show_clip_handles(settings_.clip.has_value());
  if (before.grid != settings_.grid) rebuild_grid();
  if (before.map != settings_.map || before.map_opacity != settings_.map_opacity ||
      before.map_on_terrain != settings_.map_on_terrain)
    draw_map();
  draw_terrain();
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
  Q_EMIT drawings_changed(QString::fromStdString(layer));
}

const std::vector<SceneDrawing>& SceneView::drawings(const std::string& layer) const {
  static const std::vector<SceneDrawing> none;
  const auto it = drawings_.find(layer);
  return it == drawings_.end() ? none : it->second;
}

double SceneView::frame_target_s() const { return target_s; }

}  // namespace bole::desktop
