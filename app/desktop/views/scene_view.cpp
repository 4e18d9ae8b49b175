#include "views/scene_view.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>

#include "render/draw/color.h"
#include "render/scene/actors.h"
#include "render/scene/stem_shapes.h"
#include "render/scene/thin.h"

namespace bole::desktop {
namespace {

// Points drawn at once: software OpenGL on two cores turns this many fluently.
constexpr std::size_t point_budget = 600'000;

constexpr double highlight_m = 0.12;  // by how much the ring of the selected tree stands off its bark

}  // namespace

SceneView::SceneView(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->AddRenderer(renderer_);
  renderer_->SetBackground(1, 1, 1);
  setRenderWindow(window);
  vtkNew<vtkInteractorStyleTerrain> style;  // z stays up
  interactor()->SetInteractorStyle(style);
}

void SceneView::show_survey(std::shared_ptr<const PointCloud> points, std::shared_ptr<const Table> stems,
                            std::shared_ptr<const Table> sections, std::shared_ptr<const Trajectory> walk) {
  const bool first = !has_survey();
  points_ = std::move(points), stems_ = std::move(stems), sections_ = std::move(sections), walk_ = std::move(walk);
  rebuild();
  if (first)
    reset_camera();
  else
    renderWindow()->Render();  // an edit leaves the camera where it is
}

void SceneView::color_by(PointColor color) {
  color_ = color;
  rebuild();
  renderWindow()->Render();
}

int SceneView::actor_count() { return renderer_->GetActors()->GetNumberOfItems(); }

void SceneView::rebuild() {
  renderer_->RemoveAllViewProps();
  const Eigen::Vector3d origin = points_ ? points_->origin : Eigen::Vector3d::Zero().eval();
  if (points_ && !points_->empty()) {
    const auto indices = thin_for_drawing(*points_, Window{}, point_budget);
    renderer_->AddActor(points_actor(*points_, indices, coloring_for(*points_, indices, color_), origin, 2));
  }
  if (stems_ && stems_->rows() > 0) {
    const auto shapes = stem_shapes(*stems_, sections_.get());
    renderer_->AddActor(stems_actor(shapes, origin, true));
    renderer_->AddActor(breast_height_actor(shapes, origin, 0.04));
  }
  if (walk_ && walk_->poses.size() > 1) renderer_->AddActor(path_actor(*walk_, origin, 0.05, hex(0x1f6f9f)));
  draw_highlight();
}

void SceneView::highlight_tree(std::int64_t id) {
  highlighted_ = id;
  draw_highlight();
  renderWindow()->Render();
}

void SceneView::draw_highlight() {
  if (highlight_) renderer_->RemoveActor(highlight_);
  highlight_ = nullptr;
  if (!stems_ || !stems_->has("tree_id")) return;
  const auto ids = stems_->integers("tree_id");
  const auto it = std::ranges::find(ids, highlighted_);
  if (it == ids.end()) return;
  const auto shapes = stem_shapes(stems_->subset({static_cast<std::size_t>(it - ids.begin())}), sections_.get());
  highlight_ = breast_height_actor(shapes, points_ ? points_->origin : Eigen::Vector3d::Zero().eval(), highlight_m);
  highlight_->GetMapper()->ScalarVisibilityOff();
  highlight_->GetProperty()->SetColor(0.0, 0.45, 0.9);
  renderer_->AddActor(highlight_);
}

void SceneView::reset_camera() {
  auto* camera = renderer_->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-0.5, -1.0, 0.55);
  camera->SetViewUp(0, 0, 1);
  renderer_->ResetCamera();
  camera->Zoom(1.6);
  renderWindow()->Render();
}

}  // namespace bole::desktop
