#include "io/core/bags/raw_points.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "sensor/core/livox_packet.h"

namespace bole::io {
namespace {

// Letters and digits in lower case: "timeStamp", "time_stamp" and "timestamp" are one.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// The first of the names that a field has.
std::optional<CloudField> field_named(const std::vector<CloudField>& fields,
                                      std::initializer_list<std::string_view> names) {
  for (const auto name : names)
    for (const auto& field : fields)
      if (plain(field.name) == name) return field;
  return {};
}

template <class T>
void keep_of(std::vector<T>& values, const std::vector<std::size_t>& indices) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < indices.size(); ++i) values[i] = values[indices[i]];
  values.resize(indices.size());
}

// Takes the return numbers from the tags, and leaves out what the device is sure is noise. Devices count the returns
// from 0 or from 1.
void use_tags(const std::vector<std::int64_t>& tags, RawPoints& points) {
  points.tagged_noise = 0;
  if (tags.size() != points.positions.size() || tags.empty()) return;
  const auto number = [](std::int64_t tag) { return sensor::livox_return(static_cast<std::uint8_t>(tag)); };
  int first = number(tags.front());
  for (const auto tag : tags) first = std::min(first, number(tag));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (!sensor::is_livox_noise(static_cast<std::uint8_t>(tags[i]))) kept.push_back(i);
  points.tagged_noise = tags.size() - kept.size();
  points.return_number.resize(tags.size());
  for (std::size_t i = 0; i < tags.size(); ++i) points.return_number[i] = number(tags[i]) - first + 1;
  points.keep(kept);
}

}  // namespace

CloudLayout layout_of(const std::vector<CloudField>& fields) {
  const auto x = field_named(fields, {"x"}), y = field_named(fields, {"y"}), z = field_named(fields, {"z"});
  if (!x || !y || !z) {
    std::string names;
    for (const auto& field : fields) names += (names.empty() ? "" : ", ") + field.name;
    throw bad_input("the clouds have the fields " + (names.empty() ? "none" : names), "fields x, y and z");
  }
  CloudLayout out{*x, *y, *z, {}, {}, {}, {}, {}, false};
  // The Ouster drivers call the raw signal the intensity. Its packets give the calibrated reflectivity.
  if (field_named(fields, {"ambient", "nearir"})) out.intensity = field_named(fields, {"reflectivity"});
  if (!out.intensity) out.intensity = field_named(fields, {"intensity", "reflectivity", "intensities", "i"});
  out.ring = field_named(fields, {"ring", "channel", "laserid", "line"});
  out.time =
      field_named(fields, {"t", "time", "timestamp", "offsettime", "timeoffset", "timens", "toffset", "reltime"});
  out.return_number = field_named(fields, {"returnnumber", "returnid"});
  out.livox = field_named(fields, {"tag"}) && field_named(fields, {"line"});
  if (out.livox) out.tag = field_named(fields, {"tag"});
  return out;
}

void RawPoints::keep(const std::vector<std::size_t>& indices) {
  keep_of(positions, indices);
  keep_of(intensity, indices);
  keep_of(ring, indices);
  keep_of(return_number, indices);
  keep_of(time, indices);
}

void read_cloud_points(const CloudMessage& message, const CloudLayout& layout, RawPoints& out) {
  out.stamp_ns = message.header.stamp_ns;
  out.frame_id = std::string(message.header.frame_id);
  out.height = message.height;
  out.width = message.width;
  out.missing = message.declared - message.size();
  out.positions.resize(message.size());
  std::vector<float> column;
  const std::array axes{&layout.x, &layout.y, &layout.z};
  for (int axis = 0; axis < 3; ++axis) {
    message.values(*axes[static_cast<std::size_t>(axis)], column);
    for (std::size_t i = 0; i < column.size(); ++i) out.positions[i][axis] = column[i];
  }
  const auto take = [&message](const std::optional<CloudField>& field, auto& values) {
    values.clear();
    if (field) message.values(*field, values);
  };
  take(layout.intensity, out.intensity);
  take(layout.ring, out.ring);
  take(layout.return_number, out.return_number);
  take(layout.time, out.time);
  if (layout.livox && !layout.time) {
    out.time.resize(message.size());
    for (std::size_t i = 0; i < out.time.size(); ++i)
      out.time[i] = static_cast<double>(i) / static_cast<double>(out.time.size());
  }
  std::vector<std::int64_t> tags;
  take(layout.tag, tags);
  use_tags(tags, out);
}

void read_livox_points(const LivoxMessage& message, RawPoints& out) {
  out.stamp_ns = message.header.stamp_ns;
  out.base_ns = static_cast<std::int64_t>(message.timebase_ns & 0x7FFF'FFFF'FFFF'FFFF);
  out.frame_id = std::string(message.header.frame_id);
  out.height = 1;
  out.width = static_cast<std::uint32_t>(message.points.size());
  out.missing = 0;
  const auto count = message.points.size();
  out.positions.resize(count);
  out.intensity.resize(count);
  out.time.resize(count);
  out.ring.clear();
  out.return_number.clear();
  std::vector<std::int64_t> tags(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& point = message.points[i];
    tags[i] = point.tag;
    out.positions[i] = point.position;
    out.intensity[i] = point.reflectivity;
    out.time[i] = point.offset_ns;
  }
  use_tags(tags, out);
}

LaterReturns returns_on_one_ray(const RawPoints& points) {
  LaterReturns out;
  const auto count = static_cast<std::ptrdiff_t>(points.positions.size());
  if (points.return_number.size() != points.positions.size()) return out;
  constexpr float max_angle_rad = 5e-4F;  // coordinates are rounded to 1 mm, a point at 2 m is 0.25 mrad off at most
  constexpr std::ptrdiff_t reach = 3;     // firings have up to three returns
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (points.return_number[at] <= 1) continue;
    ++out.count;
    const Eigen::Vector3f ray = points.positions[at].normalized();
    for (auto k = std::max<std::ptrdiff_t>(0, i - reach); k < std::min(count, i + reach + 1); ++k) {
      const auto other = static_cast<std::size_t>(k);
      if (points.return_number[other] >= points.return_number[at]) continue;
      if (points.positions[other].normalized().cross(ray).norm() > max_angle_rad) continue;
      ++out.on_one_ray;
      break;
    }
  }
  return out;
}

void keep_valid(RawPoints& points, double min_range_m, double max_range_m) {
  std::vector<std::size_t> kept;
  kept.reserve(points.positions.size());
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const float range = points.positions[i].norm();
    if (range >= static_cast<float>(min_range_m) && range <= static_cast<float>(max_range_m) && range > 0 &&
        (points.time.empty() || std::isfinite(points.time[i])))
      kept.push_back(i);
  }
  if (kept.size() < points.positions.size()) points.keep(kept);
}

}  // namespace bole::io
