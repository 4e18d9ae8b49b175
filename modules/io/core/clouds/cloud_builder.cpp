#include "io/core/clouds/cloud_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/statistics.h"
#include "base/verdict.h"
#include "io/core/clouds/cloud_bounds.h"
#include "io/core/clouds/sensor_arrays.h"

namespace bole::io {
namespace {

// Coordinates beyond this are stored as offsets from an origin, because float32 resolves only nearer ones to 0.1 mm.
constexpr double near_m = 1000;
constexpr double origin_step_m = 100;
constexpr std::size_t points_for_origin = 4096;

template <class T>
T load(const std::uint8_t* p, bool swap_bytes) {
  std::array<std::uint8_t, sizeof(T)> bytes;
  std::memcpy(bytes.data(), p, sizeof(T));
  if (swap_bytes) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

// Lower case letters and digits only, without CloudCompare's prefix.
std::string letters(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out.starts_with("scalar") && out.size() > 6 ? out.substr(6) : out;
}

struct Alias {
  std::string_view file_name, array;
};
constexpr std::array aliases{
    Alias{"xm", "x"},
    Alias{"ym", "y"},
    Alias{"zm", "z"},
    Alias{"xcoord", "x"},
    Alias{"ycoord", "y"},
    Alias{"zcoord", "z"},
    Alias{"easting", "x"},
    Alias{"northing", "y"},
    Alias{"i", "intensity"},
    Alias{"int", "intensity"},
    Alias{"intensities", "intensity"},
    Alias{"reflectance", "intensity"},
    Alias{"reflectivity", "intensity"},
    Alias{"remission", "intensity"},
    Alias{"t", "time"},
    Alias{"gpstime", "time"},
    Alias{"timestamp", "time"},
    Alias{"offsettime", "time"},
    Alias{"times", "time"},
    Alias{"channel", "ring"},
    Alias{"laserid", "ring"},
    Alias{"distance", "range"},
    Alias{"return", "return_number"},
    Alias{"returnnum", "return_number"},
    Alias{"returnid", "return_number"},
    Alias{"numreturns", "number_of_returns"},
    Alias{"numberofreturn", "number_of_returns"},
    Alias{"nreturns", "number_of_returns"},
    Alias{"class", "classification"},
    Alias{"scananglerank", "scan_angle"},
    Alias{"pointsource", "point_source_id"},
    Alias{"r", "red"},
    Alias{"g", "green"},
    Alias{"b", "blue"},
    Alias{"diffusered", "red"},
    Alias{"diffusegreen", "green"},
    Alias{"diffuseblue", "blue"},
    Alias{"nir", "near_infrared"},
    Alias{"infrared", "near_infrared"},
    Alias{"tree", "tree_id"},
    Alias{"hag", "height_above_ground"},
};

ArrayType column_type_for(const std::string& array, SourceType source) {
  // Text and decimal colours are scaled when their largest value is known.
  if (is_colour(array) && source != SourceType::uint8 && source != SourceType::uint16 &&
      source != SourceType::packed_rgb)
    return ArrayType::float32;
  if (const auto* known = find_array(array)) return known->type;
  switch (source) {
    case SourceType::uint8:
      return ArrayType::uint8;
    case SourceType::uint16:
      return ArrayType::uint16;
    case SourceType::int8:
    case SourceType::int16:
    case SourceType::int32:
      return ArrayType::int32;
    case SourceType::uint32:
    case SourceType::int64:
    case SourceType::uint64:
    case SourceType::float64:
      return ArrayType::float64;
    default:
      return ArrayType::float32;
  }
}

template <class T>
T saturated(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    if (std::isnan(value)) return 0;
    return static_cast<T>(std::clamp(std::nearbyint(value), static_cast<double>(std::numeric_limits<T>::min()),
                                     static_cast<double>(std::numeric_limits<T>::max())));
  }
}

// Scales a colour column whose depth the file does not declare: 0 to 1, 0 to 255 or 0 to 65535.
std::vector<std::uint16_t> full_depth(const std::vector<float>& values, float largest) {
  const float factor = largest <= 1 ? 65535.F : largest <= 255 ? 257.F : 1.F;
  std::vector<std::uint16_t> out;
  out.reserve(values.size());
  for (const float v : values) out.push_back(saturated<std::uint16_t>(v * factor));
  return out;
}

}  // namespace

std::size_t source_type_bytes(SourceType type) {
  constexpr std::array<std::size_t, 12> bytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0, 4};
  return bytes[static_cast<std::size_t>(type)];
}

double source_value(SourceType type, const std::uint8_t* p, bool swap_bytes) {
  switch (type) {
    case SourceType::int8:
      return static_cast<std::int8_t>(*p);
    case SourceType::uint8:
      return *p;
    case SourceType::int16:
      return load<std::int16_t>(p, swap_bytes);
    case SourceType::uint16:
      return load<std::uint16_t>(p, swap_bytes);
    case SourceType::int32:
      return load<std::int32_t>(p, swap_bytes);
    case SourceType::packed_rgb:
    case SourceType::uint32:
      return load<std::uint32_t>(p, swap_bytes);
    case SourceType::int64:
      return static_cast<double>(load<std::int64_t>(p, swap_bytes));
    case SourceType::uint64:
      return static_cast<double>(load<std::uint64_t>(p, swap_bytes));
    case SourceType::float32:
      return load<float>(p, swap_bytes);
    case SourceType::float64:
      return load<double>(p, swap_bytes);
    case SourceType::text:
      break;
  }
  return 0;
}

bool is_colour(std::string_view array) { return array == "red" || array == "green" || array == "blue"; }

void poll_points(const Run& run, std::size_t point, double fraction) {
  constexpr std::size_t points_between_polls = 1 << 16;
  if (point % points_between_polls != 0) return;
  run.check_cancel();
  run.report(fraction, "reading points");
}

void note_missing_points(Report& report, std::uint64_t declared, std::uint64_t present, const std::string& text) {
  if (present >= declared) return;
  constexpr double whole_enough = 0.99;
  const double share = static_cast<double>(present) / static_cast<double>(declared);
  const auto told = fmt::format("{} ({:.3g} %)", text, 100 * share);
  if (share >= whole_enough)
    report.find(Severity::look, "input_damaged", told);
  else
    report.find(Severity::refused, finding_code::input_incomplete, told);
}

void warn_cut_off(Report& report, std::uint64_t declared, std::uint64_t present) {
  note_missing_points(report, declared, present,
                      "the file is cut off: the header declares " + std::to_string(declared) + " points, " +
                          std::to_string(present) + " are present and were read");
}

std::string array_name(std::string_view file_name) {
  std::string plain = letters(file_name);
  for (const auto& info : array_vocabulary())
    if (letters(info.name) == plain) return std::string(info.name);
  for (const auto& alias : aliases)
    if (alias.file_name == plain) return std::string(alias.array);
  if (plain == "x" || plain == "y" || plain == "z") return plain;
  std::string out;
  for (const char c : file_name)
    out += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                                                       : '_';
  return out;
}

struct CloudBuilder::Parts {
  struct Target {
    std::size_t field;
    std::string name;
    SourceType source;
    Column column;
    unsigned shift = 0;  // of the colour within packed_rgb
    bool byte_colour = source == SourceType::uint8 && is_colour(name);
    bool in_metres = name == arrays::range.name;
  };
  std::array<std::size_t, 3> xyz{};
  std::vector<Target> targets;
  Eigen::Matrix3d to_metres_z_up;
  bool plain = true;  // the matrix is the identity
  double metres = 1;  // per unit of the file
  Axes axes = Axes::unknown;

  // The sensor position is a coordinate like that of the point: rotated, scaled and relative to the origin.
  std::optional<std::array<std::size_t, 3>> sensor_fields;
  std::array<std::vector<float>, 3> sensor;

  std::vector<Eigen::Vector3d> first, first_sensor;  // until the origin is chosen
  bool origin_chosen = false;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  PointCloud::Positions positions;
  std::int64_t dropped = 0;

  std::optional<CloudBounds> bounds;  // in the coordinates of the file
  std::int64_t outside = 0;
  Eigen::Vector3d min_in_file = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d max_in_file = -min_in_file;

  bool has_target(std::string_view name) const {
    return std::ranges::find(targets, name, &Target::name) != targets.end();
  }

  // All three axes are needed, because one axis alone cannot be rotated.
  void take_sensor() {
    std::array<std::size_t, 3> fields{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto it = std::ranges::find(targets, sensor_arrays[axis].name, &Target::name);
      if (it == targets.end()) return;
      fields[axis] = it->field;
    }
    sensor_fields = fields;
    std::erase_if(targets, [](const Target& t) { return axis_of_sensor(t.name) >= 0; });
  }

  void add_sensor(const Eigen::Vector3d& position) {
    for (int axis = 0; axis < 3; ++axis)
      sensor[static_cast<std::size_t>(axis)].push_back(static_cast<float>(position[axis] - origin[axis]));
  }

  void choose_origin() {
    origin_chosen = true;
    if (first.empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const auto& p : first)
        if (std::abs(p[axis]) <= farthest_m) values.push_back(p[axis]);
      if (values.empty()) continue;
      const double middle = upper_median(std::move(values));
      if (std::abs(middle) > near_m) origin[axis] = origin_step_m * std::nearbyint(middle / origin_step_m);
    }
    for (const auto& p : first) positions.push_back((p - origin).cast<float>());
    for (const auto& p : first_sensor) add_sensor(p);
    first = {};
    first_sensor = {};
  }
};

CloudBuilder::CloudBuilder(const std::vector<SourceField>& fields, const CloudReadOptions& options)
    : parts_(std::make_unique<Parts>()) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  std::array<bool, 3> found{};
  std::string list;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (list.size() < 400) list += (list.empty() ? "" : ", ") + fields[f].name;
    const std::string name = array_name(fields[f].name);
    if (const auto it = std::ranges::find(names, name); it != names.end()) {
      const auto axis = static_cast<std::size_t>(it - names.begin());
      if (!found[axis]) {
        parts_->xyz[axis] = f;
        found[axis] = true;
      }
      continue;
    }
    if (fields[f].name.empty() || fields[f].name.starts_with('_') || parts_->has_target(name)) continue;
    if (fields[f].type == SourceType::packed_rgb) {
      for (const auto& [colour, shift] : {std::pair("red", 16U), std::pair("green", 8U), std::pair("blue", 0U)})
        if (!parts_->has_target(colour))
          parts_->targets.push_back({f, colour, SourceType::packed_rgb, std::vector<std::uint16_t>(), shift});
      continue;
    }
    parts_->targets.push_back({f, name, fields[f].type, make_column(column_type_for(name, fields[f].type), 0)});
  }
  if (!found[0] || !found[1] || !found[2])
    throw bad_input("the points have no " + std::string(!found[0]   ? "x"
                                                        : !found[1] ? "y"
                                                                    : "z"),
                    "fields x, y and z", list.empty() ? "There are no fields" : "There are: " + list);
  parts_->take_sensor();
  parts_->metres = metres_per_unit(options.unit);
  parts_->to_metres_z_up = parts_->metres * rotation_to_z_up(options.up);
  parts_->plain = parts_->to_metres_z_up.isIdentity(0);
  parts_->axes = options.axes;
  parts_->bounds = parse_bounds(options.bounds);
}

CloudBuilder::~CloudBuilder() = default;

void CloudBuilder::reserve(std::size_t points) {
  parts_->positions.reserve(points);
  if (parts_->sensor_fields)
    for (auto& values : parts_->sensor) values.reserve(points);
  for (auto& t : parts_->targets) std::visit([&](auto& v) { v.reserve(points); }, t.column);
}

std::size_t CloudBuilder::size() const { return parts_->positions.size() + parts_->first.size(); }

void CloudBuilder::add(std::span<const double> row) {
  auto& p = *parts_;
  Eigen::Vector3d point(row[p.xyz[0]], row[p.xyz[1]], row[p.xyz[2]]);
  if (p.bounds && point.allFinite()) {
    p.min_in_file = p.min_in_file.cwiseMin(point);
    p.max_in_file = p.max_in_file.cwiseMax(point);
    if (!p.bounds->contains(point)) {
      ++p.outside;
      return;
    }
  }
  if (!p.plain) point = p.to_metres_z_up * point;
  if (!point.allFinite() || point.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
    ++p.dropped;
    return;
  }
  if (p.sensor_fields) {
    const auto& f = *p.sensor_fields;
    const Eigen::Vector3d sensor = p.to_metres_z_up * Eigen::Vector3d(row[f[0]], row[f[1]], row[f[2]]);
    p.origin_chosen ? p.add_sensor(sensor) : p.first_sensor.push_back(sensor);
  }
  if (p.origin_chosen) {
    p.positions.push_back((point - p.origin).cast<float>());
  } else {
    p.first.push_back(point);
    if (p.first.size() >= points_for_origin) p.choose_origin();
  }
  for (auto& t : p.targets) {
    double value = row[t.field];
    if (t.source == SourceType::packed_rgb) {
      value = (saturated<std::uint32_t>(value) >> t.shift & 0xFF) * 257.0;
    } else if (t.byte_colour) {
      value *= 257;
    } else if (t.in_metres) {
      value *= p.metres;
    }
    std::visit([&](auto& v) { v.push_back(saturated<typename std::decay_t<decltype(v)>::value_type>(value)); },
               t.column);
  }
}

CloudReading CloudBuilder::finish() {
  auto& p = *parts_;
  if (!p.origin_chosen) p.choose_origin();
  if (p.bounds && p.positions.empty() && p.outside > 0) throw nothing_within(*p.bounds, p.min_in_file, p.max_in_file);
  CloudReading out;
  out.cloud = PointCloud(std::move(p.positions), p.origin);
  out.cloud.axes = p.axes;
  float brightest = 0;
  for (const auto& t : p.targets)
    if (const auto* values = std::get_if<std::vector<float>>(&t.column); values != nullptr && is_colour(t.name))
      for (const float v : *values) brightest = std::max(brightest, v);
  if (p.sensor_fields)
    for (std::size_t axis = 0; axis < 3; ++axis) out.cloud.set_column(sensor_arrays[axis], std::move(p.sensor[axis]));
  for (auto& t : p.targets) {
    if (auto* values = std::get_if<std::vector<float>>(&t.column); values != nullptr && is_colour(t.name))
      t.column = full_depth(*values, brightest);
    out.cloud.set_column(t.name, std::move(t.column));
  }
  out.report.counts["points"] = static_cast<std::int64_t>(out.cloud.size());
  out.report.counts["dropped_points"] = p.dropped;
  if (p.bounds) out.report.counts["points_outside_bounds"] = p.outside;
  if (p.dropped > 0) out.report.warn(std::to_string(p.dropped) + " points dropped: their coordinates are not numbers");
  if (out.cloud.empty()) out.report.warn("the file holds no points");
  return out;
}

}  // namespace bole::io
