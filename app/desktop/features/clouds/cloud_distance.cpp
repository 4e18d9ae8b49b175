#include "features/clouds/cloud_distance.h"

#include <QObject>
#include <cmath>

#include "base/angles.h"
#include "cloud/core/global_frame.h"
#include "geo/core/projected_crs.h"

namespace bole::desktop {
namespace {

// The frame that the last run found, in the system of the cloud.
std::optional<GlobalFrame> frame_for(const PointCloud& cloud, const Results& results) {
  if (cloud.crs_wkt.empty()) return {};
  for (const auto& [stage, outputs] : results)
    for (const auto& [port, data] : outputs.all()) {
      const auto* table = std::get_if<std::shared_ptr<const Table>>(&data);
      if (table == nullptr || *table == nullptr) continue;
      try {
        auto frame = global_frame_of((*table)->facts);
        if (!frame || frame->crs_wkt.empty()) continue;
        if (geo::ProjectedCrs(frame->crs_wkt).name() == geo::ProjectedCrs(cloud.crs_wkt).name()) return frame;
      } catch (const Error&) {
        continue;  // a system that PROJ does not know
      }
    }
  return {};
}

double to_step(double value, double step) { return std::round(value / step) * step; }

}  // namespace

render::ClipBox placed_extent(const CloudEntry& entry) {
  const auto place = entry.place();
  const auto& box = entry.read->extent;
  const Eigen::Vector3d centre = place.of((box.lo + box.hi) / 2),
                        half = place.linear().cwiseAbs() * (box.hi - box.lo) / 2;
  return {centre - half, centre + half};
}

double gap_m(const render::ClipBox& a, const render::ClipBox& b) {
  return (a.lo - b.hi).cwiseMax(b.lo - a.hi).cwiseMax(0).norm();
}

QString distance_words(double metres) {
  if (metres < 999.5) return QObject::tr("%1 m").arg(metres, 0, 'f', 0);
  const double km = metres / 1000;
  return QObject::tr("%1 km").arg(km, 0, 'f', km < 99.95 ? 1 : 0);
}

CloudMove move_onto(const CloudEntry& entry, const render::ClipBox& survey, const Results& results) {
  const auto& own = entry.read->extent;
  CloudMove move;
  if (const auto frame = frame_for(*entry.read->points, results)) {
    const Eigen::Vector2d plan = entry.pivot_m.value_or(((own.lo + own.hi) / 2).head<2>());
    const Eigen::Vector3d middle(plan.x(), plan.y(), own.lo.z());
    move.to.shift_m = frame->to_local(middle) - middle;
    if (!frame->heights_known) move.to.shift_m.z() = to_step(survey.lo.z() - own.lo.z(), 0.1);
    move.to.turn_deg = -degrees(frame->turn_rad());
    move.by_georeference = true;
    return move;
  }
  auto stays = entry;
  stays.at.shift_m.setZero();
  const auto now = placed_extent(stays);
  const Eigen::Vector3d by = (survey.lo + survey.hi - now.lo - now.hi) / 2;
  move.to = entry.at;
  move.to.shift_m = {to_step(by.x(), 1), to_step(by.y(), 1), to_step(survey.lo.z() - now.lo.z(), 0.1)};
  return move;
}

}  // namespace bole::desktop
