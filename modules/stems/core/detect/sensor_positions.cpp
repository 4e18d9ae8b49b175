#include "stems/core/detect/sensor_positions.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <limits>
#include <optional>
#include <utility>

#include "base/arrays.h"

namespace bole::stems {
namespace {

constexpr float unknown_position = std::numeric_limits<float>::quiet_NaN();

template <class T>
const std::vector<T>* column_or_null(const PointCloud& points, const ArrayInfo& info) {
  return points.has(info) ? &points.values<T>(info) : nullptr;
}

std::optional<Eigen::Vector3f> sensor_at(const Trajectory& trajectory, const Eigen::Vector3d& origin, double time) {
  try {
    return (trajectory.at(time).translation() - origin).cast<float>();
  } catch (const Error&) {
    return std::nullopt;  // a point outside the trajectory's time has no ray
  }
}

template <class F>
void for_each_point(std::size_t n, const Run& run, F&& f) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1 << 14), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) f(i);
  });
  run.check_cancel();
}

bool has_path(const PointCloud& points, const Trajectory* trajectory) {
  return trajectory && trajectory->poses.size() >= 2 && points.has(arrays::time);
}

}  // namespace

bool has_sensor_columns(const PointCloud& points) {
  return points.has(arrays::sensor_x) && points.has(arrays::sensor_y) && points.has(arrays::sensor_z);
}

bool knows_sensor(const PointCloud& points, const Trajectory* trajectory) {
  return has_sensor_columns(points) || has_path(points, trajectory);
}

CloudRays rays_of(const PointCloud& points, const Trajectory* trajectory, const StemLayer& layer, const Run& run) {
  CloudRays rays;
  rays.time = column_or_null<double>(points, arrays::time);
  rays.pass = column_or_null<std::int32_t>(points, arrays::pass);
  if (has_sensor_columns(points)) {
    rays.sensor_x = &points.values<float>(arrays::sensor_x);
    rays.sensor_y = &points.values<float>(arrays::sensor_y);
    rays.sensor_z = &points.values<float>(arrays::sensor_z);
  } else if (has_path(points, trajectory)) {
    rays.sensor.assign(layer.size(), Eigen::Vector3f::Constant(unknown_position));
    for_each_point(layer.size(), run, [&](std::size_t k) {
      if (const auto s = sensor_at(*trajectory, points.origin, (*rays.time)[layer.index[k]])) rays.sensor[k] = *s;
    });
  }
  return rays;
}

SensorOf sensor_of_points(const PointCloud& points, const Trajectory* trajectory) {
  if (has_sensor_columns(points)) {
    const auto &x = points.values<float>(arrays::sensor_x), &y = points.values<float>(arrays::sensor_y),
               &z = points.values<float>(arrays::sensor_z);
    return [&x, &y, &z](std::size_t i) -> std::optional<Eigen::Vector3f> {
      const Eigen::Vector3f s(x[i], y[i], z[i]);
      return s.allFinite() ? std::optional(s) : std::nullopt;
    };
  }
  if (!has_path(points, trajectory)) return {};
  const auto& time = points.values<double>(arrays::time);
  return [&time, trajectory, origin = points.origin](std::size_t i) { return sensor_at(*trajectory, origin, time[i]); };
}

void add_sensor_columns(PointCloud& points, const SensorOf& sensor_of, const Run& run) {
  std::vector<float> x(points.size()), y(x.size()), z(x.size());
  for_each_point(x.size(), run, [&](std::size_t i) {
    const auto s = sensor_of(i).value_or(Eigen::Vector3f::Constant(unknown_position));
    x[i] = s.x();
    y[i] = s.y();
    z[i] = s.z();
  });
  points.set_column(arrays::sensor_x, std::move(x));
  points.set_column(arrays::sensor_y, std::move(y));
  points.set_column(arrays::sensor_z, std::move(z));
}

}  // namespace bole::stems
