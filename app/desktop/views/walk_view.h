// The 3-D view of a walk: the map of a SLAM run as it grows, and single frames of the scan in it.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "views/walk_layers.h"

namespace bole::desktop {

class WalkView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit WalkView(QWidget* parent);

  void clear();
  // `frame`: the frame in work too. The camera keeps all in sight until somebody moves it.
  void show_live(LiveMap& map, bool frame);
  void show_survey(const Survey& survey, const Table* loops);
  void show_frame(const PlacedFrame& frame);
  void look_at_all();

  const WalkLayers& layers() const { return layers_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void follow_theme();
  bool camera_moved() const;
  void redraw();

  vtkNew<vtkRenderer> renderer_;
  WalkLayers layers_;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();  // where look_at_all() put the camera
};

}  // namespace bole::desktop
