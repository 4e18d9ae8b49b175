// Where stems and the sensor are, against a reference.
#pragma once

#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/charts/match_group.h"
#include "render/draw/figure.h"

namespace bole::render {

// Position errors (estimate minus reference) of matched stems with their mean and covariance ellipse (95 % of a normal
// law).
Figure position_errors(const Table& matches, double width_mm);
// Several series in one figure, each in its colour with its ellipse and statistics.
Figure position_errors(const std::vector<MatchGroup>& groups, double width_mm);

// Mean, covariance (divided by n, SPEC A11) and the square root of its largest eigenvalue.
struct ErrorSpread {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double max_sigma = 0;
};
ErrorSpread error_spread(const std::vector<Eigen::Vector2d>& errors);

// The walk from above, coloured by time, or by its distance from a reference at equal times where one is given. Both
// must be in the same axes.
Figure trajectory_plan(const Trajectory& trajectory, const Trajectory* reference, double width_mm);

}  // namespace bole::render
