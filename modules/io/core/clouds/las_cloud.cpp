#include "io/core/clouds/las_cloud.h"

#include <algorithm>
#include <cmath>

#include "io/core/clouds/cloud_builder.h"
#include "io/core/clouds/turn_cloud.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/las/las_reader.h"

namespace bole::io {
namespace {

// Coordinates that are none of this earth may be noise. They are what was written where the header has the same bounds.
bool header_has_bounds(const PointCloud& cloud, const LasInfo& info, double metres) {
  constexpr double float_rounding = 1e-6;
  const double reach = std::max(info.min.cwiseAbs().maxCoeff(), info.max.cwiseAbs().maxCoeff());
  if (!(reach * metres > farthest_m && std::isfinite(reach))) return false;
  const Eigen::Vector3d margin = float_rounding * (info.max - info.min);
  const CloudBounds declared{info.min - margin, info.max + margin};
  return std::ranges::all_of(
      cloud.positions(), [&](const auto& p) { return declared.contains(p.template cast<double>() + cloud.origin); });
}

}  // namespace

CloudReading read_las_cloud(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudReading out;
  LasReadOptions las;
  las.drop_withheld = options.drop_withheld;
  las.bounds = parse_bounds(options.bounds);
  las.resolution = options.resolution;
  las.piece = options.piece;
  las.origin_of_header = options.origin_of_header;
  out.cloud = read_las(file, las, run, &out.report);
  // The LAS reader gives coordinates as they are in the file.
  if (options.axes != Axes::unknown) out.cloud.axes = options.axes;
  const LasInfo info = las::parse_info(file, false);
  const bool declared = header_has_bounds(out.cloud, info, metres_per_unit(options.unit));
  turn_cloud(out.cloud, metres_per_unit(options.unit) * rotation_to_z_up(options.up));
  if (declared) check_coordinates(out, declared);
  out.report.counts["points"] = static_cast<std::int64_t>(out.cloud.size());
  out.report.facts["format"] = !info.compressed ? "LAS" : copc::looks_like_copc(file) ? "COPC" : "LAZ";
  if (out.cloud.empty() && options.piece.is_whole()) out.report.warn("the file holds no points");
  return out;
}

}  // namespace bole::io
