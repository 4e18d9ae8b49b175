// Multi-view stereo: depth by PatchMatch for every view, and the points on which several views agree.
#pragma once

#include <string>

#include "base/option.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "plant/core/surface/posed_views.h"

namespace bole::plant {

struct MatchOptions {
  std::string region;
  int max_width = 480;
  int neighbours = 4;
  int iterations = 4;
  double max_cost = 0.35;
  double tolerance = 0.003;
  int min_views = 3;
  double spacing = 0.0005;
  double min_share = 0.6;
};
const OptionTable& option_table(const MatchOptions*);

// Uses colour and poses alone, except that depth images, where there are any, help to find the region.
// Throws Error{bad_input} with fewer than three views.
PointCloud match_views(const ViewSource& views, const std::vector<PosedView>& posed, const MatchOptions& options,
                       const Run& run, Report& report);

}  // namespace bole::plant
