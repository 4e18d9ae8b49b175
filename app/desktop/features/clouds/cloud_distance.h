// How far a cloud lies from the survey, and the place that would bring it there.
#pragma once

#include <QString>
#include <optional>

#include "document/survey.h"
#include "features/clouds/cloud_entry.h"

namespace bole::desktop {

inline constexpr double far_cloud_m = 20;         // from here on it is told
inline constexpr double undrawn_cloud_m = 1'000;  // from here on both cannot be drawn in one view

render::ClipBox placed_extent(const CloudEntry& entry);            // of a cloud that was read
double gap_m(const render::ClipBox& a, const render::ClipBox& b);  // between two boxes; 0 where they meet
QString distance_words(double metres);                             // "35 m", "5.3 km"

struct CloudMove {
  CloudPlacing to;
  bool by_georeference = false;
};

// By the place that a stage found for the axes of the survey, where the cloud has the same coordinate system; else
// centre onto centre in the plan, whole metres, and the lowest points onto the lowest; turn, tilt and scale stay then.
CloudMove move_onto(const CloudEntry& entry, const render::ClipBox& survey, const Results& results);

}  // namespace bole::desktop
