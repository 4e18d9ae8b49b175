// Trees in the 3-D view: their numbers with symbols, and the box that cuts their stems as it cuts the points.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkPlane.h>

#include <algorithm>

#include "render/charts/columns.h"
#include "views/map_style.h"
#include "views/scene_camera.h"
#include "views/scene_view.h"

namespace bole::desktop {

vtkStandardNewMacro(MapStyle)

namespace {

constexpr std::size_t max_marks = 100;  // more would cover the points
constexpr double beside_m = 0.15;       // by which a sight passes other stems
constexpr int turns = 9;                // to each side, to find one
constexpr double above_ring_m = 0.35;   // the ring at breast height stays free

}  // namespace

void SceneView::take_trees() {
  trees_.clear();
  if (!survey_.stems || shapes_.empty()) return;
  const auto states = render::texts_or_empty(*survey_.stems, "state");
  for (const auto& shape : shapes_) {
    SceneTree tree{shape.tree_id, shape.breast_height + Eigen::Vector3d(0, 0, above_ring_m), shape.quality, {}};
    if (const auto row = survey_.row_of(shape.tree_id)) tree.state = states[*row];
    trees_.push_back(std::move(tree));
  }
}

// The selected one first, then the nearest.
void SceneView::add_trees(render::ViewFurniture& furniture, const render::PickView& view, double sheet_mm_per_px) {
  if (!settings_.trees || rendering_) return;
  struct Seen {
    render::TreeMark mark;
    double depth;
  };
  std::vector<Seen> seen;
  for (const auto& tree : trees_) {
    if (settings_.clip && !settings_.clip->contains(tree.place)) continue;
    const auto at = render::on_screen(view, tree.place);
    if (!at || at->depth > 1) continue;
    const bool strong = selection_.tree() == tree.id;
    seen.push_back({{{at->px.x() * sheet_mm_per_px, furniture.height_mm - at->px.y() * sheet_mm_per_px},
                     std::to_string(tree.id),
                     tree.quality,
                     tree.state,
                     strong},
                    strong ? -2 : at->depth});
  }
  std::ranges::stable_sort(seen, {}, &Seen::depth);
  std::vector<render::TreeMark> marks;
  for (auto& s : seen) marks.push_back(std::move(s.mark));
  furniture.trees = render::kept_apart(marks, {0, 0, furniture.width_mm, furniture.height_mm}, max_marks);
  furniture.tree_legend = settings_.legend;
}

void SceneView::clip_solids() {
  auto solids = actors_;
  solids.insert(solids.end(), terrain_.actors().begin(), terrain_.actors().end());
  for (const auto& actor : solids) {
    auto* mapper = actor->GetMapper();
    mapper->RemoveAllClippingPlanes();
    if (!settings_.clip) continue;
    const Eigen::Vector3d lo = settings_.clip->lo - origin_, hi = settings_.clip->hi - origin_;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {1.0, -1.0}) {
        const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
        vtkNew<vtkPlane> plane;
        plane->SetNormal(normal.x(), normal.y(), normal.z());
        plane->SetOrigin(side > 0 ? lo.data() : hi.data());
        mapper->AddClippingPlane(plane);
      }
  }
}

// No other stem stands before it.
bool SceneView::sees_stem(const Eigen::Vector2d& from, const render::StemShape& stem) const {
  const Eigen::Vector2d along = stem.breast_height.head<2>() - from;
  return std::ranges::none_of(shapes_, [&](const render::StemShape& other) {
    if (other.tree_id == stem.tree_id) return false;
    const Eigen::Vector2d off = other.breast_height.head<2>() - from;
    const double t = off.dot(along) / std::max(along.squaredNorm(), 1e-9);
    return t > 0 && t < 1 && (off - t * along).norm() < other.breast_radius_m + stem.breast_radius_m + beside_m;
  });
}

// From the side that needs the smallest turn for a free sight.
void SceneView::zoom_to_tree(std::int64_t id) {
  const auto it = std::ranges::find(shapes_, id, &render::StemShape::tree_id);
  if (it == shapes_.end()) return;
  if (flat()) return zoom_to(it->breast_height);
  auto* camera = renderer_->GetActiveCamera();
  approach(camera, it->breast_height - origin_, approach_m);
  const auto free = [&](double angle_deg) {
    vtkNew<vtkCamera> turned;
    turned->DeepCopy(camera);
    turned->Azimuth(angle_deg);
    return sees_stem((Eigen::Vector3d(turned->GetPosition()) + origin_).head<2>(), *it);
  };
  for (int k = 0; k <= 2 * turns; ++k) {
    const int step = (k + 1) / 2;
    const double angle_deg = (k % 2 == 0 ? step : -step) * 180.0 / turns;
    if (!free(angle_deg)) continue;
    camera->Azimuth(angle_deg);
    break;
  }
  begin_motion();  // a first frame at once, of as many points as there is time for; the rest follows
  redraw();
}

void SceneView::set_flat(bool on) { style_->flat = on; }

bool SceneView::flat() const { return style_->flat; }

}  // namespace bole::desktop
