// Keeps the cameras of two views alike: what one shows, the other shows of its own.
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <array>

class vtkRenderer;

namespace bole::desktop {

class SceneView;

class CameraLink : public QObject {
  Q_OBJECT

 public:
  // Both views must outlive it.
  CameraLink(SceneView& first, SceneView& second, QObject* parent);

  // Where zero of each scene lies: views of projected coordinates draw about an origin of their own.
  void set_origins(const Eigen::Vector3d& first, const Eigen::Vector3d& second);
  void set_linked(bool on);
  bool linked() const { return linked_; }

 private:
  void drawn_first() { drawn(0); }
  void drawn_second() { drawn(1); }
  void drawn(std::size_t which);
  void follow(std::size_t which);
  vtkRenderer* renderer(std::size_t which) const;

  std::array<SceneView*, 2> views_;
  std::array<Eigen::Vector3d, 2> origins_{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  bool linked_ = true;
};

}  // namespace bole::desktop
