// How far the scanned points cover a plot.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"

namespace bole::survey {

// The middle, in the plan, of what was scanned: between the 1st and the 99th of 100 occupied squares of 1 m along x
// and along y, so that single points far away do not move it. Nothing for a cloud without points.
std::optional<Eigen::Vector2d> middle_of(const PointCloud& points, const Run& run);

// Share of the plot's area in which no point lies, in squares of a 25th of its size (0.25 to 2 m). NaN without a
// boundary.
double empty_share(const PlotArea& area, const PointCloud& points, const Run& run);

}  // namespace bole::survey
