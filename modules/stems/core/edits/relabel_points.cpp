#include "stems/core/edits/relabel_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <limits>

#include "base/arrays.h"

namespace bole::stems {
namespace {

struct Labels {
  std::vector<std::int32_t> tree_id;
  std::vector<std::uint8_t> stem;
};

void apply(const Relabel& step, const Eigen::Vector2d& p, float height, std::int32_t& id, std::uint8_t& stem) {
  if (step.from && id != *step.from) return;
  const Relabel::Target* nearest = nullptr;
  double least = step.reach_m > 0 ? step.reach_m * step.reach_m : std::numeric_limits<double>::infinity();
  for (const auto& target : step.to)
    if (const double d = (p - target.at).squaredNorm(); d < least) least = d, nearest = &target;
  if (nearest == nullptr) return;
  if (step.reach_m > 0) {
    if (!(height >= step.bottom_m && height <= step.top_m)) return;
    stem = 1;
  }
  id = nearest->id;
  if (id == 0) stem = 0;
}

}  // namespace

PointCloud relabel_points(const PointCloud& points, const std::vector<Relabel>& steps, const Run& run) {
  if (steps.empty() || !points.has(arrays::tree_id)) return points;
  Labels labels{points.values<std::int32_t>(arrays::tree_id), points.has(arrays::stem)
                                                                  ? points.values<std::uint8_t>(arrays::stem)
                                                                  : std::vector<std::uint8_t>(points.size(), 0)};
  const auto* heights =
      points.has(arrays::height_above_ground) ? &points.values<float>(arrays::height_above_ground) : nullptr;
  const Eigen::Vector2d origin = points.origin.head<2>();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 100'000), [&](const auto& range) {
    if (run.cancelled()) return;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Eigen::Vector2d p = origin + points.positions()[i].head<2>().cast<double>();
      for (const auto& step : steps)
        apply(step, p, heights != nullptr ? (*heights)[i] : 0.0F, labels.tree_id[i], labels.stem[i]);
    }
  });
  run.check_cancel();
  PointCloud out = points;
  out.set_column(arrays::tree_id, std::move(labels.tree_id));
  if (points.has(arrays::stem)) out.set_column(arrays::stem, std::move(labels.stem));
  return out;
}

}  // namespace bole::stems
