// How high the trees are, and whether their tops are in the cloud.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/detect/ray_test.h"
#include "stems/core/tree/grow_crowns.h"

namespace bole::stems {

// Why the height of a tree is a lower bound; seen: it is its height.
enum class TopVerdict { seen, low, sparse, off_axis, overtopped, contested, at_edge, out_of_reach, cut_off, no_tip };
constexpr std::array<std::string_view, 10> choice_names(TopVerdict) {
  return {"seen",
          "only the lower stem is in the cloud",
          "few points at the top",
          "the highest point stands far beside the stem",
          "another tree reaches over the top",
          "the top may be that of another tree",
          "the tree stands at the edge of the cloud",
          "the sensor could not see higher",
          "the cloud ends there",
          "the stem ends without a tip or a crown"};
}

// Sets height_m of each stem to the highest well-supported point of its tree above its ground, and height_seen where
// that is its top. Where the highest point may be that of another tree, height_m is that of the points that stand over
// the stem and that no other tree can claim: a lower bound. Without sensor positions (`sensor_of` empty) a top counts
// as seen when it is well supported by points, stands over its stem, no other tree reaches over it or contests it, and
// it does not stand at the edge of the cloud. Its end must be that of a tree (tree_ends.h): a crown that thins out,
// above a stem that has room to narrow, and not where the cloud ends. With them it must also lie below what the sensor
// could have measured from where it saw the tree. Stems that end low in an open space become doubtful. Needs the stem
// curves and the crown bases. The report gets the number of tops and of trees that end with the cloud. Returns the
// verdicts, by stem.
std::vector<TopVerdict> measure_tops(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                                     const CrownGrowth& growth, const SensorOf& sensor_of, const Run& run,
                                     Report& report);

}  // namespace bole::stems
