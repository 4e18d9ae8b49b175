// Features of several views that show one point.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rgbd/core/matching/match_pair.h"

namespace bole::rgbd {

struct TrackedFeature {
  int view = 0;
  std::uint32_t feature = 0;
};

// Joins matches to tracks: features of different views, at most one of each: a match that would bring two features of
// one view together is left out. In a fixed order, longest first. Views without a pose take no part.
std::vector<std::vector<TrackedFeature>> join_tracks(const std::vector<const Features*>& features,
                                                     const std::vector<MatchedPair>& pairs,
                                                     const std::vector<std::optional<Pose>>& poses);

// Of these tracks those that are needed to fill every view evenly: at most `per_cell` in each of 12 x 8 cells, as far
// as the tracks of other views do not bring more.
std::vector<std::vector<TrackedFeature>> spread_tracks(const std::vector<std::vector<TrackedFeature>>& tracks,
                                                       const std::vector<const Features*>& features,
                                                       const std::vector<const CameraModel*>& cameras, int per_cell);

}  // namespace bole::rgbd
