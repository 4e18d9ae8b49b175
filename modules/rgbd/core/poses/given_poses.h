// Poses that came with the views, and whether the images agree with them.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "rgbd/core/poses/view_data.h"

namespace bole::rgbd {

// The given pose of each view. Throws Error{bad_input} for poses that are no rigid motions and where no view has one.
std::vector<std::optional<Pose>> take_given(const ViewSource& views, const Trajectory& given);

// Compares the motions between views with the matches of their images. A finding names another convention (inverse,
// axes of OpenGL, another scale) where that one fits better.
void check_given(const std::vector<std::optional<Pose>>& poses, const std::vector<ViewData>& data,
                 const std::vector<MatchedPair>& pairs, Report& report);

// Compares the distances between the views with those that the board gives. A finding names the ratio where it is off
// by more than 2 %.
void check_given_scale(const std::vector<std::optional<Pose>>& poses, const std::vector<ViewData>& data,
                       Report& report);

}  // namespace bole::rgbd
