// The points of a survey in a scene that is turned and zoomed: drawn from an octree within a budget per frame.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <unordered_map>

#include "render/beside/ground_below.h"
#include "render/beside/point_parts.h"
#include "render/scene/pick.h"
#include "render/scene/point_octree.h"
#include "render/scene/point_paint.h"

namespace bole::render {

// What is left out of the drawing.
struct PointFilter {
  Interval height{-1e9, 1e9};                 // above ground where known, else z
  std::shared_ptr<const GroundBelow> ground;  // of clouds without heights: what theirs are above; null: z counts
  bool everything() const { return height.lo <= -1e9 && height.hi >= 1e9; }
};

// World axes; nothing beyond it is drawn. Cheap to change: prepared points stay.
struct ClipBox {
  Eigen::Vector3d lo = Eigen::Vector3d::Zero(), hi = Eigen::Vector3d::Ones();
  bool operator==(const ClipBox&) const = default;
  bool contains(const Eigen::Vector3d& p) const {
    return (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all();
  }
};

class PointLayer {
 public:
  PointLayer() = default;
  ~PointLayer();
  PointLayer(const PointLayer&) = delete;
  PointLayer& operator=(const PointLayer&) = delete;

  // Null: nothing is drawn then.
  void show(std::shared_ptr<PointNodes> nodes, const Eigen::Vector3d& origin);
  // The same of an octree in memory, which must be that of the cloud's positions; both may be null.
  void show(std::shared_ptr<const PointCloud> cloud, std::shared_ptr<const PointOctree> octree,
            const Eigen::Vector3d& origin) {
    show(nodes_in_memory(std::move(cloud), std::move(octree)), origin);
  }
  void set_paint(PointPaint paint);
  void set_filter(const PointFilter& filter);
  void set_clip(const std::optional<ClipBox>& box);
  void set_point_size(double px);
  void set_opacity(double opacity);  // 0 to 1; 1: nothing shines through

  // Chooses what the renderer's camera sees, at most `budget` points, and prepares at most `fresh` points that were not
  // drawn before. False: more was chosen than prepared, call again for the next frame.
  bool update(vtkRenderer* renderer, std::size_t budget, std::size_t fresh);

  std::size_t drawn() const { return drawn_; }      // points of the last update
  std::size_t fresh() const { return fresh_; }      // of them, those that were prepared for it
  std::size_t awaited() const { return awaited_; }  // nodes that the last update wanted and that are not here yet
  // Those that are drawn within `reach_px` of a pixel, and some that are a little farther from it.
  std::vector<PointSet> drawn_near(const PickView& view, const Eigen::Vector2d& at_px, double reach_px) const;
  const PointPaint& paint() const { return paint_; }

 private:
  struct Tile {
    vtkSmartPointer<vtkActor> actor;
    std::vector<std::uint32_t> indices;  // that passed the filter
    Eigen::AlignedBox3d box;             // around them, world axes
    std::uint64_t last_use = 0;
  };
  void clear();
  Tile make_tile(PointSet points) const;
  void place_clip_planes();
  void clip(Tile& tile) const;
  void forget_unused();

  std::shared_ptr<PointNodes> nodes_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  PointPaint paint_;
  PointFilter filter_;
  std::optional<ClipBox> clip_;
  vtkNew<vtkPlaneCollection> clip_planes_;
  double size_px_ = 2, opacity_ = 1;
  std::unordered_map<std::uint32_t, Tile> tiles_;
  vtkNew<PointParts> parts_;               // the actors of the tiles
  vtkSmartPointer<vtkRenderer> renderer_;  // that they were added to
  std::uint64_t frame_ = 0;
  std::size_t drawn_ = 0, fresh_ = 0, awaited_ = 0;
};

}  // namespace bole::render
