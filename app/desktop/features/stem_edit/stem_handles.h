// Handles on the selected stem in the 3-D view: its place and radius at breast height, which the points near the drawn
// circle correct as in the slice, its lean, across which they are fitted anew, and the height of its top. What is let
// go becomes edits of the document.
#pragma once

#include <QObject>
#include <optional>

#include "document/stem_circle.h"
#include "views/scene_drawing.h"

namespace bole::desktop {

class Workbench;

class StemHandles : public QObject {
  Q_OBJECT

 public:
  explicit StemHandles(Workbench& bench);

  bool shown() const { return shown_; }
  void show(bool on);

 private:
  // World coordinates; what the handles stand for.
  struct Shape {
    Eigen::Vector3d breast = Eigen::Vector3d::Zero();
    double radius_m = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  // metres in plan per metre upwards
    std::optional<double> height_m;                   // above the ground; none where it is not known
  };
  void take_stem();
  void drag(const std::string& handle, const Eigen::Vector3d& at, bool released);
  void change(const std::string& handle, const Eigen::Vector3d& at);
  void fit(const Eigen::Vector2d& slope);
  void draw();
  std::vector<SceneDrawing> drawings() const;
  SceneDrawing handle(const std::string& id) const;
  Eigen::Vector3d axis_at(double above_breast_m) const;
  double top_m() const;  // of the handle of the height, above the ground
  std::string circle_words() const;
  std::vector<stems::StemEdit> lean_edits(bool as_drawn) const;
  std::vector<stems::StemEdit> edits(const std::string& handle, bool as_drawn) const;

  Workbench& bench_;
  bool shown_ = false;
  std::optional<StemPlace> stem_;
  Shape is_, drawn_;
  // Of the slice while a circle or the lean is dragged, from breast height as it is.
  std::optional<std::vector<stems::CutPoint>> points_;
  std::optional<stems::RobustCircle> fit_;  // of them; plan of the stems
};

}  // namespace bole::desktop
