// The boundary of the plot over the 3-D view. While it is edited, its centre can be dragged: the options of the stage
// follow as one step of undo.
#pragma once

#include <QObject>
#include <optional>

#include "cloud/plot_area.h"
#include "document/survey.h"

namespace bole::desktop {

class Workbench;

class PlotBoundary : public QObject {
  Q_OBJECT

 public:
  explicit PlotBoundary(Workbench& bench);

  const std::optional<PlotArea>& area() const { return area_; }  // that counts; none before a run
  bool edited() const { return edited_; }
  void edit(bool on);
  void move_to(const Eigen::Vector2d& centre);  // throws bole::Error

 private:
  void make_commands();
  void show_survey(const Survey& survey);
  void draw(const std::optional<Eigen::Vector2d>& centre = {});  // elsewhere while it is dragged
  const pipeline::StageNode* stage() const;                      // null: the document has none

  Workbench& bench_;
  std::optional<PlotArea> area_;
  bool edited_ = false;
};

}  // namespace bole::desktop
