// Rigid motions that many pairs of trees of two maps agree on.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/run.h"
#include "survey/core/revisit/align_stands.h"

namespace bole::survey {

// Whether their diameters let them be one tree; unknown diameters go with all.
bool may_be_same(const StandTree& first, const StandTree& second, const AlignLimits& limits);

Eigen::Isometry2d motion_of(double turn_rad, const Eigen::Vector2d& shift);
double turn_of(const Eigen::Isometry2d& T);
bool same_motion(const Eigen::Isometry2d& a, const Eigen::Isometry2d& b, double turn_rad, double shift_m);

// The 60 motions T_first_second that most pairs of trees of like length and diameters vote for, the likeliest first.
// Both lists are about their middles. The thickest 200 trees of each take part.
std::vector<Eigen::Isometry2d> likely_motions(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                                              const AlignLimits& limits, const Run& run);

}  // namespace bole::survey
