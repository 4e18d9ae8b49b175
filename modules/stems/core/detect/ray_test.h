// Do rays pass through a candidate? Bark stops them, leaves and chance do not.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/run.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

struct RayCount {
  std::int64_t through = 0;  // rays through the core that end beyond the stem
  std::int64_t stopped = 0;  // rays towards the core that end at the stem
};

// Sensor position (offset from the cloud's origin) of point i; nothing when not known.
using SensorOf = std::function<std::optional<Eigen::Vector3f>(std::size_t i)>;

// Rays that cross the core of each stem (0.6 of its radius, less where the stem is thin) between 0.6 and 2.4 m above
// its ground. Of many points an even choice is tested, by their places: in a part of a cloud
// (cloud/core/whole/whole_size.h) the same as in the whole.
std::vector<RayCount> count_rays(const std::vector<Stem>& stems, const PointCloud& points, const SensorOf& sensor_of,
                                 const Run& run);

// Share of rays that pass through; NaN when too few were aimed at the core to tell.
double share_through(const RayCount& count);

}  // namespace bole::stems
