// The bundle adjustment of matched views, and what its residuals say of each view.
#pragma once

#include <array>
#include <cstdint>

#include <optional>
#include <vector>

#include "rgbd/core/poses/bundle.h"
#include "rgbd/core/poses/tracks.h"
#include "rgbd/core/poses/view_data.h"

namespace bole::rgbd {

struct MadeBundle {
  Bundle bundle;
  std::vector<std::array<std::uint8_t, 3>> colors;  // of the points
  int tracks = 0;                                   // before some were chosen
};

// First poses and matches; points begin at the measured depth that the other views agree with best, else where the rays
// meet. `with_board`: the corners of the board are known points.
MadeBundle make_bundle(const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs,
                       const std::vector<std::optional<Pose>>& poses, bool with_board);

struct ViewResidual {
  int observations = 0, corners = 0;
  double pixel = 0;  // root mean square of both, pixels
  double depth = 0;  // root mean square, metres; NaN without depth
};
std::vector<ViewResidual> residuals_of(const Bundle& bundle);

}  // namespace bole::rgbd
