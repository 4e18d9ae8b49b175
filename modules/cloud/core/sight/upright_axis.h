// Which axis of a cloud points up.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/run.h"
#include "cloud/core/sight/sample.h"
#include "cloud/first_sight.h"

namespace bole {
inline namespace cloud {
namespace sight {

// The point with axis `up` (0, 1, 2) turned to z.
Eigen::Vector3f z_up(const Eigen::Vector3f& p, int up);

AxisEvidence evidence_for(const std::vector<Eigen::Vector3d>& thinned_points, const Sample& sample, int axis,
                          const Run& run);

// An axis with several stems along it and next to none along the others.
std::optional<int> upright_axis(const std::array<AxisEvidence, 3>& along);

}  // namespace sight
}  // namespace cloud
}  // namespace bole
