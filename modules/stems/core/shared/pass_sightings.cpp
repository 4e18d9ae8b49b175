#include "stems/core/shared/pass_sightings.h"

#include <algorithm>

#include "base/transform.h"
#include "stems/core/fit/stem_quality.h"

namespace bole::stems {
namespace {

constexpr int min_sighting = 20;  // points of a pass that tell where it sees a stem

}  // namespace

std::vector<PassSighting> pass_sightings(const std::vector<Stem>& fitted, const DriftPrior& drift,
                                         const MeasureOptions& options) {
  std::vector<PassSighting> sightings;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const auto& s = fitted[k];
    if (objection(s, options) || s.drift.target.size() == 0) continue;
    const Eigen::Matrix3d to_plan = rotation_between(Eigen::Vector3d::UnitZ(), s.direction);
    const auto offsets = likeliest_offsets(s.drift, drift);
    for (std::size_t i = 0; i < std::min(offsets.size(), s.pass_seen.size()); ++i)
      if (const auto& seen = s.pass_seen[i]; seen.points >= min_sighting)
        sightings.push_back({static_cast<int>(k), seen.pass, seen.time_s,
                             (to_plan * Eigen::Vector3d(offsets[i].x(), offsets[i].y(), 0)).head<2>()});
  }
  return sightings;
}

void restore_spread(Stem& stem, const std::vector<PassAlignment>& alignments) {
  std::vector<Eigen::Vector2d> offset;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < std::min(stem.pass_offset.size(), stem.pass_seen.size()); ++i) {
    const auto& seen = stem.pass_seen[i];
    if (seen.points < min_sighting) continue;
    offset.push_back(stem.pass_offset[i]);
    for (const auto& a : alignments) offset.back() += a.at(seen.pass, seen.time_s);
    mean += offset.back();
  }
  for (const auto& o : offset)
    stem.pass_spread_m = std::max(stem.pass_spread_m, (o - mean / static_cast<double>(offset.size())).norm());
}

}  // namespace bole::stems
