#include "cloud/core/sight/upright_axis.h"

#include <algorithm>

#include "base/angles.h"
#include "cloud/core/sight/cell_heights.h"
#include "cloud/stem_axes.h"

namespace bole {
inline namespace cloud {
namespace sight {

Eigen::Vector3f z_up(const Eigen::Vector3f& p, int up) {
  if (up == 1) return {p.x(), -p.z(), p.y()};
  if (up == 0) return {-p.z(), p.y(), p.x()};
  return p;
}

AxisEvidence evidence_for(const std::vector<Eigen::Vector3d>& thinned_points, const Sample& sample, int axis,
                          const Run& run) {
  AxisEvidence out;
  constexpr double max_lean_deg = 25;
  for (const auto& s : find_stem_axes(thinned_points, Eigen::Vector3d::Unit(axis), radians(max_lean_deg), run)) {
    ++out.stems;
    out.stem_metres += s.length_m;
  }
  std::vector<Eigen::Vector3f> turned;
  turned.reserve(sample.points.size());
  for (const auto& p : sample.points) turned.push_back(z_up(p, axis));
  const CellHeights cells(turned, cell_size_m(turned, 2));
  out.ground_seen = cells.continuing_share(false);
  out.top_continues = cells.continuing_share(true);
  return out;
}

std::optional<int> upright_axis(const std::array<AxisEvidence, 3>& along) {
  constexpr std::size_t min_stems = 3;
  constexpr double min_metres = 8, times_the_next = 4;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& e = along[static_cast<std::size_t>(axis)];
    double next = 0;
    for (int other = 0; other < 3; ++other)
      if (other != axis) next = std::max(next, along[static_cast<std::size_t>(other)].stem_metres);
    if (e.stems >= min_stems && e.stem_metres >= min_metres && e.stem_metres > times_the_next * next &&
        e.ground_seen >= e.top_continues)
      return axis;
  }
  return {};
}

}  // namespace sight
}  // namespace cloud
}  // namespace bole
