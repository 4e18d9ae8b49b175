// A cloud in the list of those to look at.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "alignment/core/cloud_difference.h"
#include "render/beside/placed_cloud.h"
#include "running/cloud_reading.h"

namespace bole::desktop {

// Where a cloud is shown: numbers as a person types them.
struct CloudPlacing {
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  double turn_deg = 0;                    // counter-clockwise seen from above
  double tilt_x_deg = 0, tilt_y_deg = 0;  // about east and north, before the turn
  double scale = 1;

  bool operator==(const CloudPlacing& other) const = default;
};

inline constexpr double min_scale = 0.001, max_scale = 1000;

// Other than names that readers know ("distance" is a range).
inline const std::string distance_column = "cloud_distance", rise_column = "height_difference";
inline bool is_of_distances(const std::string& column) { return column == distance_column || column == rise_column; }

// How far a cloud lies from another one.
struct CloudDistances {
  int from = 0;  // id of the other cloud; 0: the survey
  QString from_name;
  alignment::DifferenceOptions options;
  alignment::CloudDifference found;  // its numbers; those of the points are columns of the cloud
  std::string color_before;
  std::shared_ptr<const ReadCloud> read_before;  // without these columns
};

struct CloudEntry {
  int id = 0;
  QString path;  // absolute
  bool visible = true;
  render::Color color;
  std::string color_by;  // an array; empty: all points have `color`
  double point_px = 0;   // 0: as the survey
  double opacity = 1;
  CloudPlacing at;
  // Turned, tilted and scaled about; in the coordinates of the file. Its middle, once it was read. Lists of before
  // clouds could be tilted have no height.
  std::optional<Eigen::Vector2d> pivot_m;
  std::optional<double> pivot_z_m;

  // Of this session.
  std::shared_ptr<const ReadCloud> read;  // null while it is being read, and where it cannot be
  QString problem;                        // why it cannot be
  std::shared_ptr<const CloudDistances> distances;
  double color_range_m = 1;  // of their colours

  QString name() const;  // of the file
  Eigen::Vector3d pivot() const;
  render::CloudPlace place() const;
  void know_pivot();  // of what was read, where the list has none
};

// The first of a few colours that none of them has; they differ for the colour-blind too.
render::Color free_cloud_color(const std::vector<CloudEntry>& taken);

}  // namespace bole::desktop
