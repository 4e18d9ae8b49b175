#include "io/core/clouds/las_cloud.h"

#include <algorithm>
#include <array>

#include "io/core/clouds/sensor_arrays.h"
#include "io/core/las/las_reader.h"

namespace bole::io {
namespace {

// The LAS reader gives coordinates as they are in the file.
void to_metres_z_up(PointCloud& cloud, const CloudReadOptions& options) {
  const Eigen::Matrix3d matrix = metres_per_unit(options.unit) * rotation_to_z_up(options.up);
  if (options.axes != Axes::unknown) cloud.axes = options.axes;
  if (matrix.isIdentity(0)) return;
  const auto turn = [&matrix](Eigen::Vector3f& p) { p = (matrix * p.cast<double>()).cast<float>(); };
  auto positions = cloud.positions();
  for (auto& p : positions) turn(p);
  cloud.set_positions(std::move(positions));
  if (std::ranges::all_of(sensor_arrays, [&](const ArrayInfo& a) { return cloud.has(a); })) {
    std::array<std::vector<float>, 3> sensor;
    for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis] = cloud.values<float>(sensor_arrays[axis]);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      Eigen::Vector3f p(sensor[0][i], sensor[1][i], sensor[2][i]);
      turn(p);
      for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis][i] = p[static_cast<int>(axis)];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) cloud.set_column(sensor_arrays[axis], std::move(sensor[axis]));
  }
  cloud.origin = matrix * cloud.origin;
  cloud.scale = (matrix * cloud.scale).cwiseAbs();
}

}  // namespace

CloudReading read_las_cloud(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudReading out;
  LasReadOptions las;
  las.drop_withheld = options.drop_withheld;
  out.cloud = read_las(file, las, run, &out.report);
  to_metres_z_up(out.cloud, options);
  out.report.counts["points"] = static_cast<std::int64_t>(out.cloud.size());
  out.report.facts.try_emplace("format", "LAS");
  if (out.cloud.empty()) out.report.warn("the file holds no points");
  return out;
}

}  // namespace bole::io
