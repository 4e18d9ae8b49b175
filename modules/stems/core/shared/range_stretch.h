// A walk that the map makes too short, or too long, against the ranges that were measured.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "stems/core/fit/cylinder_fit.h"

namespace bole::stems {

// Of less the stems cannot be sure (cylinder_fit's model of the beam, the shape of stems).
inline constexpr double min_stretch_to_take_out = 2e-4, still_to_take_out = 5e-5;

// Mean over stems of bounded influence, drawn to zero by what good maps have. Values as shares of the range.
RangeStretchPrior mean_range_stretch(const std::vector<RangeStretchEvidence>& stems);

// The cloud with every point moved in the plan towards its sensor by `stretch` of its distance in the plan. Needs
// `sensor_x` and `sensor_y`; points without a sensor stay.
PointCloud without_stretch(const PointCloud& points, double stretch, const Run& run);

// Metric range_stretch; finding walk_too_short or walk_too_long for what was taken out of the points.
void tell_range_stretch(double stretch, double taken_out, Report& report);

}  // namespace bole::stems
