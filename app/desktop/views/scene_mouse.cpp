// What the mouse does in the 3-D view: picks, takes places, drags grips, zooms.
#include <vtkCamera.h>

#include <QMouseEvent>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "views/scene_camera.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr double pick_reach_px = 6, click_px = 4, grip_px = 9, line_px = 5, behind_m = 0.5;
constexpr double outline_step_px = 2, outline_tolerance_px = 1;
const std::string outline_layer = "outline";

}  // namespace

std::optional<SceneView::PointThere> SceneView::point_at(const QPoint& at, bool of_survey_only) {
  if (!survey_.points && clouds().empty()) return {};
  const auto view = pick_view();
  const Eigen::Vector2d px = to_pixels(at);
  const double reach_px = pick_reach_px * devicePixelRatioF();
  auto drawn = layer_.drawn_near(view, px, reach_px);
  const std::size_t of_survey = drawn.size();
  std::vector<const SceneCloud*> owners;
  if (!of_survey_only) clouds_.add_drawn(view, px, reach_px, drawn, owners);
  const auto point = render::pick_point(view, drawn, px, reach_px);
  if (!point) return {};
  for (std::size_t k = of_survey; k < drawn.size(); ++k)
    if (drawn[k].cloud == point->cloud) return PointThere{*point, owners[k - of_survey]};
  return PointThere{*point};
}

std::optional<std::uint32_t> SceneView::picked() const {
  return picked_ && picked_->cloud == survey_.points ? std::optional(picked_->index) : std::nullopt;
}

void SceneView::pick(const QPoint& at) {
  const auto view = pick_view();
  facts_.clear();
  std::optional<std::int64_t> tree;
  const auto there = point_at(at);
  picked_ = there ? std::optional(there->point) : std::nullopt;
  const bool of_survey = !there || there->beside == nullptr;
  if (const auto camera = cameras_.at(view, to_pixels(at), line_px * devicePixelRatioF())) {
    // A camera is hidden by points before it.
    const auto point = picked_ ? render::on_screen(view, picked_->position()) : std::nullopt;
    if (!point || camera->depth <= point->depth) {
      picked_.reset();
      Q_EMIT point_picked({});
      selection_.select_view(camera->view);
      return redraw();
    }
  }
  if (picked_) {
    if (!of_survey) facts_ << there->beside->name;
    for (const auto& line : render::describe_point(*picked_->cloud, picked_->index))
      facts_ << QString::fromStdString(line);
    if (of_survey && picked_->cloud->has(arrays::tree_id))  // trees of another survey have other numbers
      if (const auto id = picked_->cloud->values<std::int32_t>(arrays::tree_id)[picked_->index]; id > 0) tree = id;
  }
  if (const auto stem = render::pick_stem(view, shapes_, to_pixels(at), 2 * devicePixelRatioF())) {
    // A stem hides what lies behind it, and is hidden by points before it.
    const auto point = picked_ ? render::on_screen(view, picked_->position()) : std::nullopt;
    if (!tree && (!point || stem->depth <= point->depth)) tree = stem->tree_id;
  }
  const auto before = selection_.tree();
  if (tree && survey_.row_of(*tree)) selection_.select(tree);
  Q_EMIT point_picked(facts_);
  if (selection_.tree() == before) redraw();  // another stem has been drawn with the point already
}

void SceneView::set_place_taker(const QObject* taker, Takes takes) {
  if (taker == place_taker_ && takes == takes_) return;
  place_taker_ = taker;
  takes_ = taker == nullptr ? Takes::places : takes;
  stroking_ = false;
  drop_outline();
  setCursor(taker != nullptr ? Qt::CrossCursor : Qt::ArrowCursor);
  Q_EMIT place_taker_changed(taker);
}

// A stem is opaque: what is seen there is its bark.
bool SceneView::behind_a_stem(const Eigen::Vector3d& point, const QPoint& at) {
  const auto view = pick_view();
  const auto stem = render::pick_stem(view, shapes_, to_pixels(at), 0);
  const auto place = render::on_screen(view, point);
  return stem && place && place->depth > stem->depth + behind_m;
}

void SceneView::give_place(const render::PickedPoint& point, int beside) {
  taken_cloud_ = point.cloud;
  taken_beside_ = beside;
  Q_EMIT place_taken(exact_position(*point.cloud, point.index), point.index);
}

void SceneView::take_place(const QPoint& at) {
  if (const auto there = point_at(at); there && !behind_a_stem(there->point.position(), at)) {
    give_place(there->point, there->beside == nullptr ? 0 : there->beside->id);
  } else if (const auto ground = render::on_plane(pick_view(), to_pixels(at), whole().lo.z())) {
    taken_cloud_ = nullptr;
    taken_beside_ = 0;
    Q_EMIT place_taken(*ground, QVariant());
  }
}

void SceneView::drop_outline() {
  path_px_.clear();
  cursor_px_.reset();
  draw_outline();
  Q_EMIT outline_dropped();
}

void SceneView::take_stroke(const QPoint& at, bool begins) {
  if (const auto there = point_at(at, true)) Q_EMIT stroke_taken(there->point.position(), begins);
}

SceneOutline SceneView::outline_drawn() {
  auto* camera = renderer_->GetActiveCamera();
  std::optional<Eigen::Vector3d> eye;
  if (!parallel()) eye = Eigen::Vector3d(camera->GetPosition()) + origin_;
  const Eigen::Vector3d target = Eigen::Vector3d(camera->GetFocalPoint()) + origin_;
  auto path = simplified(path_px_, outline_tolerance_px * devicePixelRatioF());
  if (cursor_px_) path.push_back(*cursor_px_);
  return outline_of(path, pick_view(), target, eye);
}

void SceneView::draw_outline() {
  std::vector<SceneDrawing> drawings;
  if (path_px_.size() > 1 || (cursor_px_ && !path_px_.empty())) {
    SceneDrawing d;
    d.lines = {outline_drawn().corners};
    if (!d.lines[0].empty()) d.lines[0].push_back(d.lines[0].front());
    d.strong = true;
    drawings.push_back(std::move(d));
  }
  set_drawings(outline_layer, std::move(drawings));
}

void SceneView::take_outline() {
  cursor_px_.reset();
  const auto outline = outline_drawn();
  if (takes_ == Takes::outlines) path_px_.clear();
  draw_outline();
  if (outline.corners.size() >= 3) Q_EMIT outline_taken(outline);
}

// The nearest one.
std::optional<Grip> SceneView::grip_at(const QPoint& at) {
  const auto view = pick_view();
  const auto px = to_pixels(at);
  double nearest_px = grip_px * devicePixelRatioF();
  std::optional<Grip> found;
  for (const auto& [layer, drawings] : drawings_)
    for (std::size_t d = 0; d < drawings.size(); ++d) {
      if (!drawings[d].strong) continue;
      for (std::size_t g = 0; g < drawings[d].grips.size(); ++g)
        if (const auto place = render::on_screen(view, drawings[d].grips[g]);
            place && (place->px - px).norm() <= nearest_px) {
          nearest_px = (place->px - px).norm();
          found = Grip{layer, d, g, drawings[d].grips[g], drawings[d].id, drawings[d].rail};
        }
    }
  return found;
}

bool SceneView::click_drawing(const QPoint& at) {
  const auto view = pick_view();
  double nearest_px = line_px * devicePixelRatioF();
  const std::string* found = nullptr;
  std::size_t which = 0;
  for (const auto& [layer, drawings] : drawings_)
    for (std::size_t d = 0; d < drawings.size(); ++d)
      if (const double px = distance_px(drawings[d], view, to_pixels(at)); px <= nearest_px) {
        nearest_px = px;
        found = &layer;
        which = d;
      }
  if (found == nullptr) return false;
  Q_EMIT drawing_clicked(QString::fromStdString(*found), static_cast<int>(which));
  return true;
}

// The superclass hands every event to VTK before the handlers below see it: a grip that is dragged would turn the
// camera.
bool SceneView::event(QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::MouseButtonPress) {
    const auto* press = static_cast<QMouseEvent*>(event);
    const bool grips = press->button() == Qt::LeftButton && place_taker_ == nullptr;
    dragged_ = grips ? grip_at(press->pos()) : std::nullopt;
    const bool left = place_taker_ != nullptr && press->button() == Qt::LeftButton;
    if (takes_ != Takes::corners) path_px_.clear();
    if (left && (takes_ == Takes::outlines || takes_ == Takes::corners)) {
      cursor_px_.reset();
      path_px_.push_back(to_pixels(press->pos()));
    }
    stroking_ = left && takes_ == Takes::strokes && point_at(press->pos(), true);
  }
  const bool mouse =
      type == QEvent::MouseButtonPress || type == QEvent::MouseMove || type == QEvent::MouseButtonRelease;
  // VTK draws a frame when the button is let go. Where a click follows it is one with what the click changes.
  if (type == QEvent::MouseButtonRelease) click_.emplace(*this);
  // Past VTK's own event(), which would hand the mouse to its interactor.
  // NOLINTNEXTLINE(bugprone-parent-virtual-call)
  const bool done = takes_drag() && mouse ? QOpenGLWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
  click_.reset();
  return done;
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->pos();
  if (stroking_) take_stroke(event->pos(), true);
  if (!takes_drag()) QVTKOpenGLNativeWidget::mousePressEvent(event);
}

// What was clicked twice becomes the centre of rotation, and of the view.
void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || place_taker_ != nullptr) return;
  double_clicked_ = true;
  Eigen::Vector3d place;
  if (const auto there = point_at(event->pos()))
    place = there->point.position() - origin_;
  else if (const auto stem = render::pick_stem(pick_view(), shapes_, to_pixels(event->pos()), 0))
    place = stem_place_of(stem->tree_id) - origin_;
  else
    return;
  centre_on(renderer_->GetActiveCamera(), place);
  begin_motion();
  redraw();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (stroking_) return take_stroke(event->pos(), false);
  if (!path_px_.empty()) {
    const Eigen::Vector2d at = to_pixels(event->pos());
    if (!event->buttons().testFlag(Qt::LeftButton)) {
      if (takes_ == Takes::corners) cursor_px_ = at;
      return draw_outline();
    }
    if ((at - path_px_.back()).norm() < outline_step_px) return;
    path_px_.push_back(at);
    return draw_outline();
  }
  if (!dragged_) {
    if (place_taker_ == nullptr && event->buttons() == Qt::NoButton)
      setCursor(grip_at(event->pos()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return QVTKOpenGLNativeWidget::mouseMoveEvent(event);
  }
  drag_keys_ = event->modifiers();
  if (const auto at = dragged_to(*dragged_, pick_view(), to_pixels(event->pos())))
    Q_EMIT grip_dragged(QString::fromStdString(dragged_->layer), static_cast<int>(dragged_->drawing),
                        static_cast<int>(dragged_->grip), *at, false);
}

// Frames wait for what is selected only: what else is told of may ask a question, and wait for the answer.
void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const bool still = (event->pos() - pressed_at_).manhattanLength() <= click_px;
  const bool picks = still && event->button() == Qt::LeftButton && place_taker_ == nullptr && !takes_drag();
  if (!picks) click_.reset();
  if (std::exchange(stroking_, false)) return stroke_ended();
  if (!path_px_.empty()) return event->button() == Qt::LeftButton ? take_outline() : void();
  if (dragged_) {
    const auto grip = *std::exchange(dragged_, std::nullopt);
    const auto at = dragged_to(grip, pick_view(), to_pixels(event->pos()));
    drag_keys_ = event->modifiers();
    Q_EMIT grip_dragged(QString::fromStdString(grip.layer), static_cast<int>(grip.drawing), static_cast<int>(grip.grip),
                        !still && at ? *at : grip.at, true);
    return;
  }
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  if (still && event->button() == Qt::RightButton) Q_EMIT menu_asked(mapToGlobal(event->pos()));
  if (!still || event->button() != Qt::LeftButton || (!has_survey() && cameras().empty())) return;
  if (std::exchange(double_clicked_, false)) return;
  if (place_taker_ != nullptr) return take_place(event->pos());
  if (!click_drawing(event->pos())) pick(event->pos());
}

void SceneView::wheelEvent(QWheelEvent* event) {
  if (!path_px_.empty()) return event->accept();  // its corners are places of this view
  const auto view = pick_view();
  const Eigen::Vector2d px = to_pixels(event->position().toPoint());
  zoom_towards(renderer_->GetActiveCamera(), {2 * px.x() / view.width_px - 1, 2 * px.y() / view.height_px - 1},
               view.width_px / view.height_px, std::pow(1.2, event->angleDelta().y() / 120.0));
  begin_motion();
  redraw();
  event->accept();
}

}  // namespace bole::desktop
