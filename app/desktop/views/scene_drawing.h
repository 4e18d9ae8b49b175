// Lines with a label that lie over the 3-D view: measurements, rows.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "render/scene/pick.h"
#include "render/scene/view_furniture.h"

namespace bole::desktop {

// World coordinates, metres.
struct SceneDrawing {
  std::string id;  // of what it stands for; a drag goes on with the drawing of the same id when they are made anew
  std::vector<std::vector<Eigen::Vector3d>> lines;
  std::vector<Eigen::Vector3d> marks;
  std::vector<Eigen::Vector3d> grips;   // places that can be dragged, at their height
  std::optional<Eigen::Vector3d> rail;  // unit: the grips slide along this direction instead
  std::string label;                    // at `label_at`; none when empty
  Eigen::Vector3d label_at = Eigen::Vector3d::Zero();
  bool strong = false;   // selected
  bool warning = false;  // something is doubtful here
};

// A closed line about `middle`, across the unit `normal`.
std::vector<Eigen::Vector3d> ring_about(const Eigen::Vector3d& middle, const Eigen::Vector3d& normal, double radius_m);

// Projects a drawing and adds it; `sheet_mm_per_px` of the view's pixels.
void add_to(render::ViewFurniture& furniture, const SceneDrawing& drawing, const render::PickView& view,
            double sheet_mm_per_px);

struct Grip {
  std::string layer;
  std::size_t drawing = 0, grip = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  std::string id;  // of the drawing
  std::optional<Eigen::Vector3d> rail;
};

// Where a grip goes when the mouse is at a place of the screen; nothing where that cannot be told.
std::optional<Eigen::Vector3d> dragged_to(const Grip& grip, const render::PickView& view, const Eigen::Vector2d& at_px);

// Distance in pixels of a place on the screen from the lines of a drawing; infinity when none is seen.
double distance_px(const SceneDrawing& drawing, const render::PickView& view, const Eigen::Vector2d& at_px);

}  // namespace bole::desktop
