// An estimated path beside its reference: both over each other with the revisits as lines, and the error along the way.
#pragma once

#include <optional>

#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/draw/figure.h"

namespace bole::render {

struct TrajectoryComparison {
  const Trajectory* estimate = nullptr;  // in the axes of the reference
  const Trajectory* reference = nullptr;
  // Revisits by from_time_s and to_time_s, coloured by `true_pose` or `right` where there is such a column; may be
  // null.
  const Table* loops = nullptr;
};

// The estimate laid over the reference by the rigid motion that makes the distances at equal times least (Umeyama 1991
// without scale): what absolute trajectory errors are stated after. As it is where fewer than three times are common.
Trajectory aligned_to(const Trajectory& estimate, const Trajectory& reference);
// The motion itself: from the axes of the estimate to those of the reference. None with fewer than three common times.
std::optional<Pose> alignment_to(const Trajectory& estimate, const Trajectory& reference);

// From above. Throws Error{bad_input} when a trajectory has fewer than two poses, as do the others.
Figure trajectory_overlay(const TrajectoryComparison& comparison, double width_mm);

// Distance between the two at equal times, and its horizontal and vertical part, over the way.
// The axis of the error reaches at least to `min_top_cm`: charts that are to be compared have it in common.
Figure trajectory_error_chart(const TrajectoryComparison& comparison, double width_mm, double min_top_cm = 0);
double greatest_error_cm(const TrajectoryComparison& comparison);

// Both on one sheet.
Figure trajectory_sheet(const TrajectoryComparison& comparison, double width_mm);

}  // namespace bole::render
