// Courses of a camera through a survey: one view for each frame of a film.
#pragma once

#include <vector>

#include "cloud/trajectory.h"
#include "render/scene/view_point.h"

namespace bole::render {

// Through all stops, smoothly (cubic Hermite curves of eye and centre) and as fast everywhere as their distances allow.
// Parallel views become views in perspective that show as much. Throws Error{bad_input} for fewer than two stops.
std::vector<ViewPoint> flight_through(const std::vector<ViewPoint>& stops, std::size_t frames);

struct WalkFlight {
  double above_m = 0.3;   // the eye over the path of the sensor
  double ahead_m = 6;     // where it looks
  double smoothed_m = 3;  // of the path: steps of the walk do not shake the picture
};

// Along a walk at one speed, looking ahead. Throws Error{bad_input} for a walk shorter than a metre.
std::vector<ViewPoint> flight_along(const Trajectory& walk, const WalkFlight& options, std::size_t frames);

}  // namespace bole::render
