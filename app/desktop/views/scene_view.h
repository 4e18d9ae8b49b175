// The 3-D view of a survey: points, fitted stems and the walk, drawn from the same parts as the figures of the report.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "cloud/data.h"
#include "render/scene/point_color.h"

class vtkActor;

namespace bole::desktop {

class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent);

  // Any of them may be null.
  void show_survey(std::shared_ptr<const PointCloud> points, std::shared_ptr<const Table> stems,
                   std::shared_ptr<const Table> sections, std::shared_ptr<const Trajectory> walk);
  void color_by(PointColor color);
  void reset_camera();
  // Draws a ring about a tree of the stem table; none for an id that is not there.
  void highlight_tree(std::int64_t id);

  int actor_count();
  bool has_survey() const { return points_ != nullptr || stems_ != nullptr; }

 private:
  void rebuild();
  void draw_highlight();

  vtkNew<vtkRenderer> renderer_;
  std::shared_ptr<const PointCloud> points_;
  std::shared_ptr<const Table> stems_, sections_;
  std::shared_ptr<const Trajectory> walk_;
  PointColor color_ = PointColor::height;
  vtkSmartPointer<vtkActor> highlight_;
  std::int64_t highlighted_ = 0;
};

}  // namespace bole::desktop
