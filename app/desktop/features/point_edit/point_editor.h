// Points selected in the 3-D view or the cross-section by a brush, a polygon or a box, and given to a tree, to no tree,
// to the ground or to noise. What is selected stands out until Enter makes edits of the document of it.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "cloud/core/regions/point_edits.h"
#include "views/scene_outline.h"

class QDockWidget;

namespace bole::desktop {

class PointPanel;
class Workbench;

class PointEditor : public QObject {
  Q_OBJECT

 public:
  explicit PointEditor(Workbench& bench);

  enum class Tool { brush, polygon, box };
  void start(Tool tool);
  void stop();
  std::optional<Tool> tool() const { return tool_; }

  const std::vector<std::uint32_t>& selected() const { return selected_; }  // points of the survey shown
  void apply();                                                             // one step of undo; throws bole::Error
  void drop();                                                              // what is selected

 private:
  void make_commands();
  void take_outline(const SceneOutline& outline);
  void take_stroke(const Eigen::Vector3d& place, bool begins);
  void take_place(const Eigen::Vector3d& place);
  void put_box();
  void select_again();
  void draw();
  PointRegion region(PointRegion::Kind kind) const;
  std::vector<PointEdit> edits() const;
  Eigen::Vector2d selected_tree() const;
  void recolour(const PointEdit& edit, const std::vector<std::uint32_t>& points);
  bool ready() const;

  Workbench& bench_;
  PointPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  std::optional<Tool> tool_;
  std::vector<PointRegion> regions_;
  std::optional<Eigen::Vector3d> box_at_;
  std::vector<std::uint32_t> selected_;
};

}  // namespace bole::desktop
