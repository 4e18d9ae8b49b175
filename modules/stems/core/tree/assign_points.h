// Which tree every point belongs to, which points are bark, and how high the trees are.
#pragma once

#include <vector>

#include "base/run.h"
#include "stems/core/detect/ray_test.h"

namespace bole::stems {

struct PointLabels {
  std::vector<std::int32_t> tree_id;  // 0: none
  std::vector<std::uint8_t> stem;     // 1: bark
};

// A point belongs to the nearest axis within the reach of its height: near the stem below, up to crown_radius from
// search_top upwards. Bark lies within bark_tolerance of the fitted surface over the measured part of the stem.
PointLabels assign_points(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                          const Run& run);

// Sets height_m of each stem to its highest well-supported point above its ground.
void measure_heights(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, const Run& run);

// Sets height_seen. With sensor positions: from some of the places that the tree was scanned from, the sensor would
// have measured a return 1.5 m above the highest one too, so that the top ends there (crowns in between may still hide
// more). Without (`sensor_of` empty): the tree reaches well above the lowest limbs at least.
void judge_tops(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                const SensorOf& sensor_of, const Run& run);

}  // namespace bole::stems
