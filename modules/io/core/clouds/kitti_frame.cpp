#include "io/core/clouds/kitti_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

constexpr std::size_t point_bytes = 16;

}  // namespace

bool looks_like_kitti_frame(Bytes file) {
  if (file.empty() || file.size() % point_bytes != 0) return false;
  constexpr std::size_t points_looked_at = 4096;
  constexpr double far_m = 2000, brightest = 1e6, allowed_share = 0.01;
  const std::size_t points = file.size() / point_bytes, step = std::max<std::size_t>(1, points / points_looked_at);
  std::size_t looked_at = 0, odd = 0, placed = 0;
  for (std::size_t i = 0; i < points; i += step, ++looked_at) {
    const auto value = [&](std::size_t k) {
      return source_value(SourceType::float32, file.data() + i * point_bytes + 4 * k);
    };
    const double reach = std::max({std::abs(value(0)), std::abs(value(1)), std::abs(value(2))});
    const double intensity = value(3);
    // Numbers that are not, or far beyond what a sensor sees. Text and compressed data give almost only such.
    if (!(reach <= far_m && intensity >= -1 && intensity <= brightest)) ++odd;
    constexpr double origin_m = 1e-6;
    if (reach > origin_m) ++placed;
  }
  return static_cast<double>(odd) <= allowed_share * static_cast<double>(looked_at) && placed > 0;
}

CloudReading read_kitti_frame(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudBuilder builder({{"x", SourceType::float32},
                        {"y", SourceType::float32},
                        {"z", SourceType::float32},
                        {"intensity", SourceType::float32}},
                       options);
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
