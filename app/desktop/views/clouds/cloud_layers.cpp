#include "views/clouds/cloud_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bole::desktop {
namespace {

// Two paints of the same words look alike.
std::string words_of(const render::PointPaint& paint) {
  return fmt::format("{} {} {} {} {} {} {} {}", static_cast<int>(paint.kind), paint.array, paint.range.lo,
                     paint.range.hi, static_cast<const void*>(paint.map), paint.color.r, paint.color.g, paint.color.b);
}

bool same_points(const SceneCloud& a, const SceneCloud& b) {
  return a.id == b.id && a.points == b.points && a.index == b.index && a.place == b.place;
}

}  // namespace

render::PointPaint paint_of(const SceneCloud& cloud, const render::PointPaint& of_survey) {
  render::PointPaint paint;
  paint.color = cloud.color;
  if (cloud.color_by.empty()) return paint;
  paint = render::paint_by(*cloud.points, cloud.color_by);
  if (cloud.range && paint.kind == render::PointPaint::Kind::map) {
    paint.range = *cloud.range;
    paint.title = cloud.range_title.toStdString();
    if (paint.range.lo < 0) paint.map = &render::ColorMap::diverging();
    return paint;
  }
  if (paint.kind == render::PointPaint::Kind::map && of_survey.kind == paint.kind && of_survey.array == paint.array)
    return of_survey;
  return paint;
}

SectionLine own_line(const SceneCloud& cloud, const SectionLine& line) {
  const auto own = [&](const Eigen::Vector2d& plan, double z) {
    return Eigen::Vector2d(cloud.place.back({plan.x(), plan.y(), z}).head<2>());
  };
  if (cloud.place.is_upright()) return {own(line.from, 0), own(line.to, 0), line.width_m / cloud.place.scale};
  constexpr double above_coarse_m = 1;  // the highest point need not be among the coarse ones
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < cloud.points->size(); ++i) {
    low = std::min(low, cloud.points->position(i).z() - above_coarse_m);
    high = std::max(high, cloud.points->position(i).z() + above_coarse_m);
  }
  const SectionLine middle{own(line.from, (low + high) / 2), own(line.to, (low + high) / 2), 0};
  Eigen::Vector2d lo(1e9, 1e9), hi = -lo;
  for (const auto& end : {line.from, line.to})
    for (const double side : {-0.5, 0.5})
      for (const double z : {low, high}) {
        const Eigen::Vector2d corner = middle.along_and_off(own(end + side * line.width_m * line.behind(), z));
        lo = lo.cwiseMin(corner);
        hi = hi.cwiseMax(corner);
      }
  const Eigen::Vector2d off = (lo.y() + hi.y()) / 2 * middle.behind();
  return {middle.from + lo.x() * middle.direction() + off, middle.from + hi.x() * middle.direction() + off,
          hi.y() - lo.y()};
}

SectionCloud section_cloud(const SceneCloud& cloud, const render::PointPaint& of_survey) {
  // The index of a cloud on disk is that of its points before they were turned.
  return {cloud.points, cloud.disk() ? nullptr : cloud.index, paint_of(cloud, of_survey), key_of(cloud)};
}

render::CloudKey key_of(const SceneCloud& cloud) {
  auto name = cloud.name.toStdString();
  if (cloud.place.scale != 1) name = fmt::format("\u00d7{:.4f} ", cloud.place.scale) + name;
  return {std::move(name), cloud.color_by.empty() ? std::optional(cloud.color) : std::nullopt};
}

CloudLayers::~CloudLayers() {
  for (const auto& layer : layers_) forget(*layer);
}

void CloudLayers::forget(Layer& layer) {
  disconnect(layer.arrivals);
  disconnect(layer.built);
  layer.points.show(nullptr, Eigen::Vector3d::Zero());
}

void CloudLayers::set(std::vector<SceneCloud> clouds) {
  const auto clouds_before = std::exchange(clouds_, std::move(clouds));
  auto layers_before = std::exchange(layers_, {});
  for (std::size_t k = 0; k < clouds_.size(); ++k) {
    const auto same = std::ranges::find_if(clouds_before, [&](const auto& c) { return same_points(c, clouds_[k]); });
    if (same != clouds_before.end()) {
      layers_.push_back(std::move(layers_before[static_cast<std::size_t>(same - clouds_before.begin())]));
      continue;
    }
    layers_.push_back(std::make_unique<Layer>());
    show(k);
  }
  for (const auto& layer : layers_before)
    if (layer) forget(*layer);
}

// Until its octree is built a cloud is drawn from a sample.
void CloudLayers::show(std::size_t which) {
  auto& layer = *layers_[which];
  const auto& cloud = clouds_[which];
  disconnect(layer.arrivals);
  disconnect(layer.built);
  if (!origin_) return layer.points.show(nullptr, Eigen::Vector3d::Zero());
  if (cloud.disk()) {
    layer.points.show(render::placed_nodes(cloud.disk(), cloud.place), *origin_);
    layer.arrivals = connect(cloud.disk().get(), &DiskPoints::arrived, this, &CloudLayers::arrived);
    return;
  }
  const auto draw = [this, id = cloud.id, points = cloud.points, index = cloud.index.get()] {
    for (std::size_t k = 0; k < clouds_.size(); ++k)
      if (clouds_[k].id == id && clouds_[k].index.get() == index && origin_)
        layers_[k]->points.show(points, clouds_[k].index->octree(), *origin_);
  };
  if (!cloud.index->complete())
    layer.built = connect(cloud.index.get(), &PointIndex::built, this, [this, draw] {
      draw();
      Q_EMIT index_built();
    });
  draw();
}

void CloudLayers::draw_about(const std::optional<Eigen::Vector3d>& origin) {
  const bool same = origin.has_value() == origin_.has_value() && (!origin || *origin == *origin_);
  origin_ = origin;
  if (!same)
    for (std::size_t k = 0; k < clouds_.size(); ++k) show(k);
}

// Prepared points are lost with another paint or filter, and kept with another box or size.
void CloudLayers::dress(const render::PointFilter& filter, const std::optional<render::ClipBox>& clip,
                        const render::PointPaint& of_survey) {
  for (std::size_t k = 0; k < clouds_.size(); ++k) {
    auto& layer = *layers_[k];
    auto paint = paint_of(clouds_[k], of_survey);
    layer.points.set_opacity(clouds_[k].opacity);
    if (auto words = words_of(paint); words != layer.paint) {
      layer.paint = std::move(words);
      layer.points.set_paint(std::move(paint));
    }
    if (layer.height_lo != filter.height.lo || layer.height_hi != filter.height.hi ||
        layer.ground != filter.ground.get()) {
      layer.height_lo = filter.height.lo;
      layer.height_hi = filter.height.hi;
      layer.ground = filter.ground.get();
      layer.points.set_filter(filter);
    }
  }
  set_clip(clip);
}

void CloudLayers::set_clip(const std::optional<render::ClipBox>& box) {
  for (const auto& layer : layers_) layer->points.set_clip(box);
}

void CloudLayers::set_point_size(double px, double scale) {
  for (std::size_t k = 0; k < clouds_.size(); ++k)
    layers_[k]->points.set_point_size(scale * (clouds_[k].point_px > 0 ? clouds_[k].point_px : px));
}

bool CloudLayers::update(std::size_t budget, std::size_t fresh) {
  bool complete = true;
  for (const auto& layer : layers_) complete = layer->points.update(renderer_, budget, fresh) && complete;
  return complete;
}

std::size_t CloudLayers::drawn() const {
  std::size_t sum = 0;
  for (const auto& layer : layers_) sum += layer->points.drawn();
  return sum;
}

std::size_t CloudLayers::drawn(int id) const {
  for (std::size_t k = 0; k < clouds_.size(); ++k)
    if (clouds_[k].id == id) return layers_[k]->points.drawn();
  return 0;
}

std::size_t CloudLayers::fresh() const {
  std::size_t sum = 0;
  for (const auto& layer : layers_) sum += layer->points.fresh();
  return sum;
}

std::size_t CloudLayers::awaited() const {
  std::size_t sum = 0;
  for (const auto& layer : layers_) sum += layer->points.awaited();
  return sum;
}

void CloudLayers::add_drawn(const render::PickView& view, const Eigen::Vector2d& at_px, double reach_px,
                            std::vector<render::PointSet>& drawn, std::vector<const SceneCloud*>& owners) const {
  if (!origin_) return;
  for (std::size_t k = 0; k < clouds_.size(); ++k)
    for (auto& set : layers_[k]->points.drawn_near(view, at_px, reach_px)) {
      drawn.push_back(std::move(set));
      owners.push_back(&clouds_[k]);
    }
}

std::optional<render::PointPaint> CloudLayers::legend(const render::PointPaint& of_survey) const {
  if (!origin_) return {};
  for (const auto& cloud : clouds_) {
    const auto paint = paint_of(cloud, of_survey);
    if (paint.kind == render::PointPaint::Kind::map && words_of(paint) != words_of(of_survey)) return paint;
  }
  return {};
}

std::vector<render::CloudKey> CloudLayers::keys() const {
  std::vector<render::CloudKey> keys;
  if (!origin_) return keys;
  for (const auto& cloud : clouds_) keys.push_back(key_of(cloud));
  return keys;
}

}  // namespace bole::desktop
