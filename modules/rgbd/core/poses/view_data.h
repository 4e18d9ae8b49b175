// What is read from the views once: features with depth, and sightings of the board.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "rgbd/core/board/charuco_board.h"
#include "rgbd/core/features/features.h"
#include "rgbd/core/matching/match_pair.h"
#include "rgbd/core/poses/pose_options.h"

namespace bole::rgbd {

struct ViewData {
  const RgbdCamera* camera = nullptr;
  Features features;
  std::vector<BoardCorner> corners;   // of the board
  std::vector<double> corner_depths;  // metres, of each corner; 0: not measured
  BoardLayout layout;
  std::optional<BoardPose> board;  // pose by the corners
  int features_with_depth = 0;
};

// Reads all views, several at a time. Sightings of the board with another layout than most are dropped. Findings about
// the board go to `report`. Throws Error{bad_input} where no view has any feature.
std::vector<ViewData> read_views(const ViewSource& views, const PoseOptions& options, const Run& run, Report& report);

// "000017", "000018", ...: up to `max_names` of them.
std::string names_of(const ViewSource& views, const std::vector<int>& which, std::size_t max_names = 10);

}  // namespace bole::rgbd
