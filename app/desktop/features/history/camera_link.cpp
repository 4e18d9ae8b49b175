#include "features/history/camera_link.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QTimer>
#include <cmath>

#include "views/scene_view.h"

namespace bole::desktop {
namespace {

// `to` as `from`, seen from an origin that lies `shift` off. False: it was so already.
bool copy_camera(vtkCamera* from, vtkCamera* to, const Eigen::Vector3d& shift) {
  const Eigen::Vector3d eye = Eigen::Vector3d(from->GetPosition()) + shift,
                        focus = Eigen::Vector3d(from->GetFocalPoint()) + shift, up(from->GetViewUp());
  const double near = 1e-9 * (1 + eye.norm());
  const bool same = (eye - Eigen::Vector3d(to->GetPosition())).norm() < near &&
                    (focus - Eigen::Vector3d(to->GetFocalPoint())).norm() < near &&
                    (up - Eigen::Vector3d(to->GetViewUp())).norm() < 1e-9 &&
                    from->GetParallelProjection() == to->GetParallelProjection() &&
                    std::abs(from->GetParallelScale() - to->GetParallelScale()) < near &&
                    std::abs(from->GetViewAngle() - to->GetViewAngle()) < 1e-9;
  if (same) return false;
  to->SetPosition(eye.data());
  to->SetFocalPoint(focus.data());
  to->SetViewUp(up.data());
  to->SetParallelProjection(from->GetParallelProjection());
  to->SetParallelScale(from->GetParallelScale());
  to->SetViewAngle(from->GetViewAngle());
  return true;
}

}  // namespace

CameraLink::CameraLink(SceneView& first, SceneView& second, QObject* parent)
    : QObject(parent), views_{&first, &second} {
  renderer(0)->AddObserver(vtkCommand::EndEvent, this, &CameraLink::drawn_first);
  renderer(1)->AddObserver(vtkCommand::EndEvent, this, &CameraLink::drawn_second);
}

vtkRenderer* CameraLink::renderer(std::size_t which) const {
  return views_[which]->renderWindow()->GetRenderers()->GetFirstRenderer();
}

void CameraLink::set_origins(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  origins_ = {first, second};
}

void CameraLink::set_linked(bool on) {
  linked_ = on;
  if (on) follow(0);
}

// After the frame: drawing inside the drawing of another view is not allowed.
void CameraLink::drawn(std::size_t which) {
  if (linked_) QTimer::singleShot(0, this, [this, which] { follow(which); });
}

void CameraLink::follow(std::size_t which) {
  const std::size_t other = 1 - which;
  if (!linked_ || !views_[other]->isValid()) return;
  if (copy_camera(renderer(which)->GetActiveCamera(), renderer(other)->GetActiveCamera(),
                  origins_[which] - origins_[other]))
    views_[other]->draw_moving_frame();
}

}  // namespace bole::desktop
