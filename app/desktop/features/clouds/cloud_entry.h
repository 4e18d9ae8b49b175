// A cloud in the list of those to look at.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "render/beside/placed_cloud.h"
#include "running/cloud_reading.h"

namespace bole::desktop {

struct CloudEntry {
  int id = 0;
  QString path;  // absolute
  bool visible = true;
  render::Color color;
  std::string color_by;  // an array; empty: all points have `color`
  double point_px = 0;   // 0: as the survey
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  double turn_deg = 0;                     // counter-clockwise seen from above
  std::optional<Eigen::Vector2d> pivot_m;  // in the coordinates of the file; its middle, once it was read

  // Of this session.
  std::shared_ptr<const ReadCloud> read;  // null while it is being read, and where it cannot be
  QString problem;                        // why it cannot be

  QString name() const;  // of the file
  render::CloudPlace place() const;
};

// The first of a few colours that none of them has; they differ for the colour-blind too.
render::Color free_cloud_color(const std::vector<CloudEntry>& taken);

}  // namespace bole::desktop
