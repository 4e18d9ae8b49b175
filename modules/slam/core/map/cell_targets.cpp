#include "slam/core/map/cell_targets.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace bole::slam {

CellTargets::CellTargets(const DistributionMap& map, bool line, double sigma, const Run& run) : map_(map) {
  for (int level = 0; level < DistributionMap::levels; ++level) {
    auto& targets = targets_[static_cast<std::size_t>(level)];
    targets.resize(map.cells(level));
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, targets.size(), 4096), [&](const tbb::blocked_range<std::size_t>& range) {
          if (run.cancelled()) return;
          for (std::size_t cell = range.begin(); cell < range.end(); ++cell)
            if (const auto surface = map.cell_surface(level, cell); surface && is_distinct(*surface, line))
              targets[cell] = as_target(*surface, line, sigma);
        });
    run.check_cancel();
  }
}

Target CellTargets::of(std::size_t index, const Eigen::Vector3d& point_in_map,
                       const DistributionMap::CellNumbers& cells) const {
  for (std::size_t level = 0; level < targets_.size(); ++level) {
    const Target& of_cell = targets_[level][cells[level][index]];
    if (of_cell.kind == Target::Kind::none) continue;
    Target target = of_cell;
    target.mean += map_.centre_at(map_.half_cell(point_in_map), static_cast<int>(level));
    return target;
  }
  return {};
}

}  // namespace bole::slam
