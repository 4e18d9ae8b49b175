// Which of the candidates are the two targets, and which is which.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "survey/core/options.h"
#include "survey/core/retro_clusters.h"

namespace bole::survey {

struct Target {
  std::string name;  // centre or north
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::size_t points = 0;
};

struct TargetChoice {
  std::vector<Target> targets;  // centre first; empty, one or two
  std::vector<std::string> warnings;
  std::string reason;  // how the centre was told from the north
};

// `candidates` are in levelled axes, those seen from most positions first. The pair must fit options.target_distance
// where that is given. The walk starts at the plot centre: the target nearest to `walk_start` (levelled) is the centre;
// without it the one seen from more positions is taken for the centre, with a warning.
TargetChoice choose_targets(const std::vector<RetroCluster>& candidates,
                            const std::optional<Eigen::Vector3d>& walk_start, const FrameOptions& options);

}  // namespace bole::survey
