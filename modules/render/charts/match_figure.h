// Matches of features between two neighbouring views, side by side: which were kept, which were refused.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "camera/image.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct ViewMatch {
  Eigen::Vector2d a, b;  // pixels of each view
};

struct MatchPair {
  std::string name_a, name_b;
  std::vector<ViewMatch> kept, refused;
  std::map<std::string, std::size_t> reasons;  // of the refused ones
};

// Of the pairs that are nearest neighbours and have matches of both kinds, the one with the middle number of kept ones:
// what is usual, not what is best. The table is the output `matches` of rgbd.estimate_poses. Nothing where none has.
std::optional<MatchPair> typical_pair(const Table& matches);

// The pictures must not be empty. Copies them, made smaller.
Figure match_figure(const MatchPair& pair, const ColorImage& a, const ColorImage& b, double width_mm);

}  // namespace bole::render
