// All of a film in the same axes. Of a survey with a place on the earth the file of the cloud is in its coordinate
// system, those of stems, walk and views are in the axes of the plot.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

#include "base/run.h"
#include "cloud/core/global_frame.h"
#include "cloud/point_cloud.h"

namespace bole::report {

// Something that is drawn with the points, or a flight past them. `plan`: x and y of where it is.
struct GoesWith {
  std::string_view name;
  Eigen::AlignedBox2d plan;
};

struct FilmCloud {
  PointCloud points;
  std::optional<GlobalFrame> place;  // of their axes on the earth, as far as the points know it
};

// The points in the axes of what goes with them: those that they were moved from where that brings all together, else
// those that they have. Throws Error{bad_input} where something lies far from the points in both.
FilmCloud in_common_axes(const PointCloud& points, const std::vector<GoesWith>& company, const Run& run);

// A cloud that is drawn beside them. Throws Error{bad_input} where it lies far away.
PointCloud in_axes_of(const FilmCloud& film, const PointCloud& beside, const Run& run);

}  // namespace bole::report
