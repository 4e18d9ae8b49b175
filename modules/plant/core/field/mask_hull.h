// The room that the masks of an object leave to it (visual hull): Laurentini 1994.
#pragma once

#include <optional>
#include <vector>

#include "plant/core/field/field_space.h"
#include "plant/core/field/field_views.h"

namespace bole::plant {

class MaskHull {
 public:
  // Of the views that have a mask and are not kept back.
  explicit MaskHull(const std::vector<FieldView>& views);
  bool given() const { return !outlines_.empty(); }

  // Cells of the innermost box that may hold the object, by place: seen by three views or more (by all, where there are
  // fewer), and shown as empty by no more than one in twenty of those, as masks made by hand have gaps.
  std::vector<std::uint64_t> cells(const FieldSpace& space) const;

  // Box around these cells, in a lattice of some 64 cells along each side of `within`. Throws Error{bad_input} where
  // the masks have no room in common.
  Region region(const Region& within) const;

 private:
  struct Outline {
    CameraModel camera;
    Pose T_camera_world = Pose::Identity();
    // Object pixels above and left of a place, so that a square of pixels is counted with four look-ups.
    std::vector<std::int32_t> sums;
    bool shows_object(double x, double y, double radius_px) const;
  };
  bool may_hold(const Eigen::Vector3d& middle_in_world, double radius_m) const;
  std::vector<Outline> outlines_;
};

}  // namespace bole::plant
