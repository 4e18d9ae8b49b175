#include "render/scene/point_layer.h"

#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "render/beside/painted_points.h"
#include "render/scene/view_camera.h"

namespace bole::render {
namespace {

constexpr double min_px = 0.7;       // finer detail than this between points is not seen
constexpr double rounding_px = 1.0;  // of places as they are drawn, near the eye

// Eye coordinates of the layer are relative to `origin`; the octree's are relative to the cloud's.
OctreeView view_of(vtkRenderer* renderer, const Eigen::Vector3d& shift) {
  const int* size = renderer->GetSize();
  const double aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1;
  Eigen::Matrix4d translate = Eigen::Matrix4d::Identity();
  translate.topRightCorner<3, 1>() = shift;
  return {view_matrix(renderer->GetActiveCamera(), aspect) * translate, static_cast<double>(std::max(size[1], 1))};
}

}  // namespace

PointLayer::~PointLayer() {
  if (renderer_) renderer_->RemoveViewProp(parts_);
}

void PointLayer::show(std::shared_ptr<PointNodes> nodes, const Eigen::Vector3d& origin) {
  clear();
  nodes_ = std::move(nodes);
  origin_ = origin;
  place_clip_planes();  // they are relative to the origin
}

void PointLayer::set_paint(PointPaint paint) {
  clear();
  paint_ = std::move(paint);
}

void PointLayer::set_filter(const PointFilter& filter) {
  clear();
  filter_ = filter;
}

void PointLayer::set_clip(const std::optional<ClipBox>& box) {
  if (box == clip_) return;
  clip_ = box;
  place_clip_planes();
  for (auto& [i, tile] : tiles_) clip(tile);
  parts_->Modified();
}

void PointLayer::place_clip_planes() {
  clip_planes_->RemoveAllItems();
  if (clip_)
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {1.0, -1.0}) {
        const Eigen::Vector3d at = (side > 0 ? clip_->lo : clip_->hi) - origin_,
                              normal = side * Eigen::Vector3d::Unit(axis);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(at.x(), at.y(), at.z());
        plane->SetNormal(normal.x(), normal.y(), normal.z());
        clip_planes_->AddItem(plane);
      }
}

void PointLayer::clip(Tile& tile) const {
  if (!tile.actor) return;
  if (clip_)
    tile.actor->GetMapper()->SetClippingPlanes(clip_planes_);
  else
    tile.actor->GetMapper()->RemoveAllClippingPlanes();
}

void PointLayer::set_point_size(double px) {
  if (px == size_px_) return;
  size_px_ = px;
  for (auto& [i, tile] : tiles_)
    if (tile.actor) tile.actor->GetProperty()->SetPointSize(static_cast<float>(px));
  parts_->Modified();
}

void PointLayer::set_opacity(double opacity) {
  if (opacity == opacity_) return;
  opacity_ = opacity;
  for (auto& [i, tile] : tiles_)
    if (tile.actor) let_shine_through(*tile.actor, opacity);
  parts_->Modified();
}

void PointLayer::clear() {
  parts_->clear();
  tiles_.clear();
  drawn_ = awaited_ = 0;
}

PointLayer::Tile PointLayer::make_tile(PointSet all) const {
  Tile tile;
  const auto& cloud = *all.cloud;
  tile.indices = std::move(all.indices);
  if (!filter_.everything()) {
    const auto* heights = cloud.has(arrays::height_above_ground)
                              ? std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name))
                              : nullptr;
    std::erase_if(tile.indices, [&](std::uint32_t i) {
      const Eigen::Vector3d p = cloud.position(i);
      const double height = heights != nullptr ? static_cast<double>((*heights)[i])
                            : filter_.ground   ? p.z() - filter_.ground->z_at(p.head<2>())
                                               : p.z();
      return !(height >= filter_.height.lo && height <= filter_.height.hi);
    });
  }
  if (tile.indices.empty()) return tile;
  for (const auto i : tile.indices) tile.box.extend(cloud.position(i));
  tile.actor = painted_points_actor(cloud, tile.indices, paint_, origin_, size_px_, opacity_);
  clip(tile);
  return tile;
}

bool PointLayer::update(vtkRenderer* renderer, std::size_t budget, std::size_t fresh) {
  if (!nodes_) return true;
  if (renderer_ != renderer) {
    if (renderer_) renderer_->RemoveViewProp(parts_);
    renderer_ = renderer;
    renderer->AddViewProp(parts_);
  }
  ++frame_;
  const Eigen::Vector3d origin = nodes_->origin();
  auto view = view_of(renderer, origin - origin_);
  if (clip_) view.lo = (clip_->lo - origin).cast<float>(), view.hi = (clip_->hi - origin).cast<float>();
  drawn_ = fresh_ = awaited_ = 0;
  bool complete = true;
  std::vector<vtkActor*> seen;
  for (const auto i : nodes_->choose(view, budget, min_px)) {
    auto it = tiles_.find(i);
    if (it == tiles_.end()) {
      const std::size_t size = nodes_->size_of(i);
      if (fresh_ > 0 && fresh_ + size > fresh) {
        complete = false;
        continue;
      }
      auto points = nodes_->points(i);
      if (!points.cloud) {
        ++awaited_;
        continue;
      }
      fresh_ += size;
      it = tiles_.emplace(i, make_tile(std::move(points))).first;
      if (it->second.actor) parts_->add(it->second.actor);
    }
    it->second.last_use = frame_;
    drawn_ += it->second.indices.size();
    if (it->second.actor) seen.push_back(it->second.actor);
  }
  parts_->show(std::move(seen));
  forget_unused();
  return complete;
}

void PointLayer::forget_unused() {
  const std::size_t kept_points = nodes_->max_prepared();
  std::size_t points = 0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> unused;
  for (const auto& [i, tile] : tiles_) {
    points += tile.indices.size();
    if (tile.last_use != frame_) unused.emplace_back(tile.last_use, i);
  }
  if (points <= kept_points) return;
  std::ranges::sort(unused);
  for (const auto& [use, i] : unused) {
    if (points <= kept_points) return;
    auto it = tiles_.find(i);
    points -= it->second.indices.size();
    if (it->second.actor) parts_->remove(it->second.actor);
    tiles_.erase(it);
  }
}

std::vector<PointSet> PointLayer::drawn_near(const PickView& view, const Eigen::Vector2d& at_px,
                                             double reach_px) const {
  std::vector<PointSet> drawn;
  const AboutPixel about(view, origin_, at_px);
  for (const auto& [i, tile] : tiles_) {
    if (tile.last_use != frame_ || tile.indices.empty() || !may_be_near(view, tile.box, at_px, reach_px)) continue;
    const auto cloud = nodes_->cloud_of(i);
    if (!cloud) continue;
    // Coordinates as they are drawn lie one behind the other, those of the cloud do not.
    PointSet near{cloud, {}, tile.box};
    const float* at = drawn_at(*tile.actor).data();
    for (const auto index : tile.indices) {
      if (about(Eigen::Map<const Eigen::Vector3f>(at).cast<double>()).within(reach_px + rounding_px) &&
          (!clip_ || clip_->contains(cloud->position(index))))
        near.indices.push_back(index);
      at += 3;
    }
    if (!near.indices.empty()) drawn.push_back(std::move(near));
  }
  return drawn;
}

}  // namespace bole::render
