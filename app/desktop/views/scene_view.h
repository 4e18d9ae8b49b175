// The 3-D view of a survey: points, fitted stems and the walk, drawn from the same parts as the figures of the report.
// Points come from an octree: while the camera moves as many as the frame has time for, when it rests all that are
// seen.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QPoint>
#include <QTimer>
#include <chrono>
#include <vector>

#include "document/survey.h"
#include "render/scene/pick.h"
#include "render/scene/point_layer.h"
#include "selection/selection.h"

class vtkActor;

namespace bole::desktop {

class SceneOverlay;

class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  SceneView(Selection& selection, QWidget* parent);

  void show_survey(const Survey& survey);
  bool has_survey() const { return !survey_.empty(); }

  void color_by(const std::string& array);
  std::vector<std::string> colorable() const;  // arrays of the cloud
  const PointPaint& paint() const { return layer_.paint(); }
  void set_filter(const PointFilter& filter);

  void reset_camera();
  void look_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& up);  // all of the survey
  void set_parallel(bool on);
  bool parallel() const;
  void zoom_to_tree(std::int64_t id);

  // The point under a place of the widget; selects its tree, or the stem there.
  void pick(const QPoint& at);
  std::optional<std::uint32_t> picked() const { return picked_; }

  int actor_count();
  std::size_t drawn_points() const { return layer_.drawn(); }
  bool refined() const { return complete_ && !moving_; }
  // One frame as it is drawn while the camera moves; seconds. For the frame-rate test and benchmark.
  double draw_moving_frame();
  double frame_target_s() const;

 Q_SIGNALS:
  void point_picked(const QStringList& facts);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void rebuild();
  void draw_highlight();
  void redraw();
  void begin_motion();
  void before_frame();
  void after_frame();
  void place_furniture();
  PickView pick_view();
  Eigen::Vector2d to_pixels(const QPoint& at) const;

  Selection& selection_;
  Survey survey_;
  std::vector<StemShape> shapes_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::string color_array_ = "height_above_ground";
  PointFilter filter_;
  PointLayer layer_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkActor>> furniture_;
  vtkSmartPointer<vtkActor> highlight_;
  SceneOverlay* overlay_;
  std::optional<std::uint32_t> picked_;
  QStringList facts_;

  QTimer rest_;
  bool moving_ = false, complete_ = true;
  std::size_t moving_budget_;
  std::chrono::steady_clock::time_point frame_start_;
  double last_frame_s_ = 0;
  QPoint pressed_at_;
};

}  // namespace bole::desktop
