#include "slam/core/map/dense_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "slam/core/map/grid_key.h"

namespace bole::slam {
namespace {

constexpr std::size_t min_counters = 1u << 20, max_counters = 1u << 28;
constexpr std::size_t chunk = 4096;

template <class T>
void keep_every_second(std::vector<T>& v) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < v.size(); i += 2) v[to++] = v[i];
  v.resize(to);
}

}  // namespace

DenseMapBuilder::DenseMapBuilder(const DenseMapSettings& settings)
    : settings_(settings),
      columns_(settings.voxel),
      counters_(settings.expected_points == 0
                    ? max_counters
                    : std::clamp(std::bit_ceil(4 * settings.expected_points), min_counters, max_counters)) {
  // Reserved memory is not touched until it is used, and nothing is copied as the map grows.
  const std::size_t room =
      settings.expected_points == 0 ? settings.max_points : std::min(settings.max_points, settings.expected_points);
  positions_.reserve(room);
  time_.reserve(room);
  range_.reserve(room);
  intensity_.reserve(room);
  ring_.reserve(room);
  sensor_x_.reserve(room);
  sensor_y_.reserve(room);
  sensor_z_.reserve(room);
  pass_.reserve(room);
  keyframe_.reserve(room);
}

std::uint64_t DenseMapBuilder::column_of(const Eigen::Vector3f& position, const Eigen::Vector3f& sensor,
                                         std::int32_t pass) const {
  return mix_bits(columns_.key(position.cast<double>(), sensor.cast<double>()) ^
                  (static_cast<std::uint64_t>(pass + 1) * 0x9e3779b97f4a7c15ull));
}

bool DenseMapBuilder::admit(std::uint64_t column) {
  const std::size_t mask = counters_.size() - 1;
  std::uint8_t &a = counters_[column & mask], &b = counters_[(column >> 32) & mask];
  if (std::min(a, b) >= settings_.points_per_voxel) return false;
  if (a < 255) ++a;
  if (&b != &a && b < 255) ++b;
  return true;
}

bool DenseMapBuilder::survives(std::uint64_t serial) const {
  return halvings_ == 0 || (mix_bits(serial) & ((1ull << halvings_) - 1)) == 0;
}

void DenseMapBuilder::halve() {
  ++halvings_;
  keep_every_second(positions_);
  keep_every_second(time_);
  keep_every_second(range_);
  keep_every_second(intensity_);

  keep_every_second(ring_);
  keep_every_second(sensor_x_);
  keep_every_second(sensor_y_);
  keep_every_second(sensor_z_);
  keep_every_second(pass_);

  keep_every_second(keyframe_);
}

void DenseMapBuilder::add(const ScanFrame& frame, const PoseGrid& poses, std::int32_t pass, std::int32_t keyframe) {
  const std::size_t n = frame.size();
  const auto min2 = static_cast<float>(settings_.min_range * settings_.min_range),
             max2 = static_cast<float>(settings_.max_range * settings_.max_range);
  const auto inverse_span = static_cast<float>(1.0 / std::max(frame.end_time_s - frame.start_time_s, 1e-6));
  in_map_.resize(n);
  sensor_.resize(n);
  column_.resize(n);
  usable_.resize(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, chunk), [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const float r2 = frame.positions[i].squaredNorm();
      usable_[i] = r2 >= min2 && r2 <= max2 && frame.time_offset_s[i] >= 0;
      if (!usable_[i]) continue;
      const float s = std::min(1.0f, frame.time_offset_s[i] * inverse_span);
      const Eigen::Vector3d sensor = poses.translation(s);
      sensor_[i] = sensor.cast<float>();
      in_map_[i] = (poses.turned(frame.positions[i], s) + sensor).cast<float>();
      column_[i] = column_of(in_map_[i], sensor_[i], pass);
    }
  });
  const std::size_t mask = counters_.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    // The counters lie all over a large table: they are called for before it is their turn.
    if (const std::size_t next = i + 16; next < n && usable_[next]) {
      __builtin_prefetch(&counters_[column_[next] & mask], 1);
      __builtin_prefetch(&counters_[(column_[next] >> 32) & mask], 1);
    }
    if (!usable_[i]) continue;
    ++offered_;
    if (!admit(column_[i]) || !survives(serial_++)) continue;
    if (positions_.size() >= settings_.max_points) halve();
    positions_.push_back(in_map_[i]);
    time_.push_back(frame.start_time_s + frame.time_offset_s[i]);
    range_.push_back(frame.positions[i].norm());
    intensity_.push_back(i < frame.intensity.size() ? frame.intensity[i] : 0);
    ring_.push_back(i < frame.ring.size() ? frame.ring[i] : 0);
    pass_.push_back(pass);
    keyframe_.push_back(keyframe);
    sensor_x_.push_back(sensor_[i].x());
    sensor_y_.push_back(sensor_[i].y());
    sensor_z_.push_back(sensor_[i].z());
  }
}

PointCloud DenseMapBuilder::take() {
  counters_ = {};
  PointCloud cloud(std::move(positions_));
  cloud.axes = Axes::map;
  cloud.set_column(arrays::time, std::move(time_));
  cloud.set_column(arrays::range, std::move(range_));
  cloud.set_column(arrays::ring, std::move(ring_));
  cloud.set_column(arrays::intensity, std::move(intensity_));
  cloud.set_column(arrays::pass, std::move(pass_));
  cloud.set_column(arrays::keyframe, std::move(keyframe_));
  cloud.set_column(arrays::sensor_x, std::move(sensor_x_));
  cloud.set_column(arrays::sensor_y, std::move(sensor_y_));
  cloud.set_column(arrays::sensor_z, std::move(sensor_z_));
  return cloud;
}

}  // namespace bole::slam
