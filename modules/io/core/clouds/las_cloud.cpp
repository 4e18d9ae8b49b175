#include "io/core/clouds/las_cloud.h"

#include "io/core/clouds/turn_cloud.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/las/las_reader.h"

namespace bole::io {
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
  turn_cloud(out.cloud, metres_per_unit(options.unit) * rotation_to_z_up(options.up));
  out.report.counts["points"] = static_cast<std::int64_t>(out.cloud.size());
  const bool packed = las::parse_info(file, false).compressed;
  out.report.facts["format"] = !packed ? "LAS" : copc::looks_like_copc(file) ? "COPC" : "LAZ";
  if (out.cloud.empty() && options.piece.is_whole()) out.report.warn("the file holds no points");
  return out;
}

}  // namespace bole::io
