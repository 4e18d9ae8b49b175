// The tables and the cloud that tell how the poses were found.
#pragma once

#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "rgbd/core/poses/make_bundle.h"
#include "rgbd/core/poses/match_views.h"
#include "rgbd/core/poses/pose_uncertainty.h"

namespace bole::rgbd {

enum class TrackingState { tracked, lost, given };
constexpr std::array<std::string_view, 3> choice_names(TrackingState) { return {"tracked", "lost", "given"}; }

// One row per view: view, time_s, name, state, features, matches (kept, with other views), inliers (observations of the
// bundle adjustment), corners (of the board), residual_px, residual_depth_mm, place_sd_mm, turn_sd_deg (NaN: not
// known).
Table tracking_table(const ViewSource& views, const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs,
                     const std::vector<TrackingState>& states, const std::vector<ViewResidual>& residuals,
                     const std::vector<PoseSigma>& sigmas);

// The matches of a few pairs of neighbours and loops, spread over the views: view_a, view_b, name_a, name_b, x_a_px,
// y_a_px, x_b_px, y_b_px, state (kept, refused), reason (kept, ratio, mutual, gms, still, depth). At most 300 kept and
// 300 refused of each pair; the facts hold the counts of all.
Table match_table(const ViewSource& views, const std::vector<ViewData>& data, const ViewMatcher& matcher);

// Points that at least two views see, with colours.
PointCloud sparse_cloud(const MadeBundle& made);

}  // namespace bole::rgbd
