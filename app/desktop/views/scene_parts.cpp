// What the 3-D view is made of: points, stems, the walk, the grid, the ring of the selected tree, and how far it
// reaches.
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "render/draw/color.h"
#include "render/scene/actors.h"
#include "render/scene/stem_shapes.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr double highlight_m = 0.12;  // by how much the ring of the selected tree stands off its bark
constexpr std::size_t max_marked = 300'000;
constexpr double marked_wider_px = 2;  // than other points

}  // namespace

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
  if (survey_.index && survey_.index->disk()) {
    const auto& info = survey_.index->disk()->tree().info();
    return {info.min, info.max};
  }
  Eigen::Vector3f lo = survey_.points->positions().front(), hi = lo;
  for (const auto& p : survey_.points->positions())
    if (p.allFinite()) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  return {survey_.points->origin + lo.cast<double>(), survey_.points->origin + hi.cast<double>()};
}

int SceneView::actor_count() {
  return renderer_->GetActors()->GetNumberOfItems() - (marked_ ? 1 : 0) +
         (survey_.points && !survey_.points->empty() ? 1 : 0);
}

void SceneView::mark_points(const std::vector<std::uint32_t>& points) {
  if (!marked_ && points.empty()) return;
  marked_points_ = points;
  if (marked_) renderer_->RemoveActor(marked_);
  marked_ = nullptr;
  if (survey_.points && !points.empty()) {
    const std::size_t step = points.size() / max_marked + 1;
    std::vector<std::uint32_t> drawn;
    for (std::size_t i = 0; i < points.size(); i += step) drawn.push_back(points[i]);
    marked_ = render::points_actor(*survey_.points, drawn, {}, origin_,
                                   (settings_.point_size_px + marked_wider_px) * devicePixelRatioF());
    marked_->GetMapper()->ScalarVisibilityOff();
    const render::Color orange = render::hex(0xff7a00);
    marked_->GetProperty()->SetColor(orange.r, orange.g, orange.b);
    renderer_->draw_afresh(marked_);
    renderer_->AddActor(marked_);
  }
  Q_EMIT points_marked();
  redraw();
}

void SceneView::rebuild() {
  if (marked_) renderer_->RemoveActor(marked_);
  marked_ = nullptr;
  marked_points_.clear();
  layer_.show(nullptr, origin_);
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
  path_ = nullptr;
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
    show_points();
  }
  ground_.reset();
  clouds_.draw_about(has_survey() ? std::optional(origin_) : std::nullopt);
  dress_clouds();
  // Plants of rows have places only.
  if (survey_.stems && survey_.stems->rows() > 0 && survey_.stems->has("dbh_cm") && survey_.stems->has("z_m")) {
    shapes_ = render::stem_shapes(*survey_.stems, survey_.sections.get());
    add(render::stems_actor(shapes_, origin_, true));
    add(render::breast_height_actor(shapes_, origin_, 0.04));
  }
  if (survey_.walk && survey_.walk->poses.size() > 1) {
    path_ = render::path_actor(*survey_.walk, origin_, 0.05, {});
    add(path_);
  }
  take_trees();
  draw_terrain();
  draw_in_theme();
  draw_map();
}

// What has other colours on a dark ground.
void SceneView::draw_in_theme() {
  const render::Color walk = look_.dark ? render::on_dark(render::ink::path) : render::hex(0x1f6f9f);
  if (path_) path_->GetProperty()->SetColor(walk.r, walk.g, walk.b);
  rebuild_grid();
  draw_highlight();
  draw_cameras();
}

void SceneView::set_map(std::shared_ptr<const SceneMap> map) {
  if (map == map_.map()) return;
  map_.set(std::move(map));
  draw_map();
  draw_terrain();
  redraw();
  Q_EMIT map_changed();
  Q_EMIT settings_changed();
}

void SceneView::draw_map() {
  if (!settings_.map || !has_survey()) return map_.hide();
  map_.draw(origin_, whole_.lo.z(), settings_.map_on_terrain ? survey_.terrain.get() : nullptr, settings_.map_opacity);
}

void SceneView::draw_terrain() {
  const bool below_a_map = map() && settings_.map && settings_.map_on_terrain;
  terrain_.draw(settings_.terrain ? survey_.terrain : nullptr, origin_, below_a_map);
  clip_solids();
}

Eigen::Vector2d SceneView::north() const { return map() ? map()->north : Eigen::Vector2d::UnitY(); }

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

// The look of the survey goes for the clouds beside it, as far as they can have it.
void SceneView::dress_clouds() {
  auto filter = settings_.filter;
  if (!filter.everything() && !clouds().empty()) {
    if (!ground_ && survey_.points) ground_ = std::make_shared<const render::GroundBelow>(*survey_.points);
    if (ground_ && !ground_->empty()) filter.ground = ground_;
  }
  clouds_.dress(filter, settings_.clip, layer_.paint());
  size_points();
}

// Sizes are told in the pixels of Qt; VTK counts those of the screen.
void SceneView::size_points(double scale) {
  point_ratio_ = devicePixelRatioF();
  layer_.set_point_size(settings_.point_size_px * point_ratio_ * scale);
  clouds_.set_point_size(settings_.point_size_px, point_ratio_ * scale);
}

void SceneView::set_clouds(std::vector<SceneCloud> clouds) {
  clouds_.set(std::move(clouds));
  dress_clouds();
  begin_motion();
  redraw();
  Q_EMIT clouds_changed();
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
  renderer_->draw_afresh(highlight_);
  renderer_->AddActor(highlight_);
}

}  // namespace bole::desktop
