// View > Plan map: the plot from above, north up, in parallel projection, with the numbers of its trees and without the
// crowns that hide them. Turned off, the view is what it was.
#pragma once

#include <QObject>
#include <optional>

#include "views/view_point.h"
#include "views/view_settings.h"

namespace bole::desktop {

class Workbench;

class PlanMap : public QObject {
  Q_OBJECT

 public:
  explicit PlanMap(Workbench& bench);

  bool on() const { return before_.has_value(); }
  void turn(bool on);

 private:
  struct Before {
    ViewSettings settings;
    ViewPoint point;
  };
  void look_down();

  Workbench& bench_;
  std::optional<Before> before_;
  Eigen::Vector2d north_ = Eigen::Vector2d::UnitY();  // that is up
};

}  // namespace bole::desktop
