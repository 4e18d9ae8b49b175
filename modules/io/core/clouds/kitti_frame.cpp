#include "io/core/clouds/kitti_frame.h"

#include <array>

#include "io/core/clouds/cloud_builder.h"

namespace bole::io {

CloudReading read_kitti_frame(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudBuilder builder({{"x", SourceType::float32},
                        {"y", SourceType::float32},
                        {"z", SourceType::float32},
                        {"intensity", SourceType::float32}},
                       options);
  constexpr std::size_t point_bytes = 16;
  std::array<double, 4> row{};
  builder.reserve(file.size() / point_bytes);
  for (std::size_t i = 0; i + point_bytes <= file.size(); i += point_bytes) {
    if (i % (point_bytes << 16) == 0) run.check_cancel();
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = source_value(SourceType::float32, file.data() + i + 4 * k);
    builder.add(row);
  }
  auto out = builder.finish();
  out.report.facts["format"] = "KITTI frame";
  if (file.size() % point_bytes != 0) out.report.warn("the file is cut off within its last point");
  return out;
}

}  // namespace bole::io
