// A circle that a person draws about a stem at breast height, and the edits that make it the stem's own.
#pragma once

#include <optional>
#include <vector>

#include "document/stem_cut.h"
#include "stems/core/edits/stem_edits.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::desktop {

constexpr double min_drawn_radius_m = 0.01, max_drawn_radius_m = 2.5;

// What the points near a drawn circle ask for, fitted as stems.edit fits an added stem; nothing where they hold no
// circle. Points and circle are in the same plan axes.
std::optional<stems::RobustCircle> circle_near(const std::vector<Eigen::Vector2d>& points,
                                               const render::SliceCircle& drawn);

// The same across an axis that leans by `slope` (metres in plan per metre of height). Points and circle are in the plan
// from one middle.
std::optional<stems::RobustCircle> leaning_circle_near(const std::vector<stems::CutPoint>& points,
                                                       const render::SliceCircle& drawn, const Eigen::Vector2d& slope);

// Moves a stem to `centre` (axes of the stems) and gives it the diameter of `radius_m`.
std::vector<stems::StemEdit> circle_edits(const StemPlace& stem, const Eigen::Vector2d& centre, double radius_m);

}  // namespace bole::desktop
