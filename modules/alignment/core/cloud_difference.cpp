#include "alignment/core/cloud_difference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/core/point_tree.h"
#include "alignment/core/quantile.h"
#include "alignment/core/thinned_points.h"

namespace bole::alignment {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t plane_points = 12, block = 200'000;

struct Gap {
  float distance_m = none, rise_m = none;
};

Gap gap_of(const PointTree& tree, const Eigen::Vector3f& p, const DifferenceOptions& options) {
  const auto nearest = tree.nearest(p);
  if (!(static_cast<double>(nearest.distance_m) <= options.max_m)) return {};
  const auto& there = tree.points()[nearest.index];
  Gap gap{nearest.distance_m, p.z() - there.z()};
  if (!options.to_plane) return gap;
  const auto plane = plane_at(tree, there, plane_points);
  const float off = plane.normal.dot(p - plane.centre);
  // At an edge the plane goes on where the other cloud ends: its points know better.
  if (plane.normal.isZero() || std::abs(off) >= gap.distance_m) return gap;
  return {std::abs(off), off * plane.normal.z()};
}

void summarize(CloudDifference& difference) {
  std::vector<float> found;
  double squares = 0;
  for (const float d : difference.distance_m)
    if (std::isfinite(d)) {
      found.push_back(d);
      squares += static_cast<double>(d) * static_cast<double>(d);
    }
  difference.beyond = difference.compared - found.size();
  difference.rms_m = std::sqrt(squares / static_cast<double>(found.size()));
  difference.distances = histogram_of_distances(difference.distance_m, difference.compared);
  difference.rises = histogram_of_rises(difference.rise_m, difference.compared);
  difference.median_m = difference.distances.median_m;
  difference.p95_m = difference.distances.hi95_m;
  difference.largest_m = quantile(found, difference.compared, 1);
}

}  // namespace

CloudDifference difference_of(const PointCloud& cloud, const PointCloud& from, const DifferenceOptions& options,
                              const Run& run) {
  if (!(options.max_m > 0)) throw bad_input("a distance of " + std::to_string(options.max_m) + " m", "more than 0");
  const Box box = box_of(cloud);
  if (box.isEmpty() || box_of(from).isEmpty()) throw bad_input("a cloud without points", "two with points");
  run.report(0, "gather points");
  const Eigen::Vector3d origin = box.center();
  auto there = offsets_in(from, grown(box, options.max_m), origin);
  CloudDifference difference;
  difference.distance_m.assign(cloud.size(), none);
  difference.rise_m.assign(cloud.size(), none);
  difference.compared =
      static_cast<std::size_t>(std::ranges::count_if(cloud.positions(), [](const auto& p) { return p.allFinite(); }));
  run.check_cancel();
  if (!there.empty()) {
    const PointTree tree(std::move(there));
    const Eigen::Vector3d shift = cloud.origin - origin;
    for (std::size_t begin = 0; begin < cloud.size(); begin += block) {
      run.check_cancel();
      run.report(0.2 + 0.8 * static_cast<double>(begin) / static_cast<double>(cloud.size()), "measure distances");
      tbb::parallel_for(begin, std::min(begin + block, cloud.size()), [&](std::size_t i) {
        const auto& offset = cloud.positions()[i];
        if (!offset.allFinite()) return;
        const Gap gap = gap_of(tree, (offset.cast<double>() + shift).cast<float>(), options);
        difference.distance_m[i] = gap.distance_m;
        difference.rise_m[i] = gap.rise_m;
      });
    }
  }
  summarize(difference);
  run.report(1, "measure distances");
  return difference;
}

}  // namespace bole::alignment
