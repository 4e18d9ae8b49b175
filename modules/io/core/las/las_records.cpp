#include "io/core/las/las_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/core/las/las_columns.h"

namespace bole::io::las {

namespace {

constexpr std::array<const ArrayInfo*, 12> field_arrays{&arrays::intensity,
                                                        &arrays::time,
                                                        &arrays::classification,
                                                        &arrays::return_number,
                                                        &arrays::number_of_returns,
                                                        &arrays::scan_angle,
                                                        &arrays::user_data,
                                                        &arrays::point_source_id,
                                                        &arrays::red,
                                                        &arrays::green,
                                                        &arrays::blue,
                                                        &arrays::near_infrared};

// Whether a point record of the layout has a field for the column.
bool has_field(std::string_view name, const PointLayout& layout) {
  if (is_flag_column(name)) return layout.extended || (name != "overlap" && name != "scanner_channel");
  if (name == arrays::near_infrared.name) return layout.near_infrared >= 0;
  if (name == arrays::red.name || name == arrays::green.name || name == arrays::blue.name) return layout.colour >= 0;
  return std::ranges::any_of(field_arrays, [&](const ArrayInfo* info) { return info->name == name; });
}

ExtraType extra_type(const Column& column) {
  constexpr std::array<ExtraType, 5> types{ExtraType::u8, ExtraType::u16, ExtraType::i32, ExtraType::f32,
                                           ExtraType::f64};
  return types[column.index()];
}

double whole_offset(double origin, double scale) {
  // Whole kilometres print and compare best; whole metres are nearly as good.
  for (const double unit : {1000.0, 1.0}) {
    const double candidate = std::round(origin / unit) * unit;
    const double steps = (origin - candidate) / scale;
    if (std::abs(steps - std::round(steps)) < 1e-5 && std::abs(steps) < 1e9) return candidate;
  }
  return origin;
}

// The value clamped to the range of its field.
double held(std::string_view name, double value, double low, double high, RecordLosses& losses) {
  const double inside = std::isnan(value) ? 0 : std::clamp(value, low, high);
  if (inside == value) return value;
  auto it = losses.held.find(name);
  if (it == losses.held.end()) it = losses.held.emplace(std::string(name), 0).first;
  ++it->second;
  return inside;
}

}  // namespace

Grid choose_grid(const PointCloud& cloud, double scale_m) {
  Grid grid;
  for (int k = 0; k < 3; ++k) {
    const bool own = cloud.scale[k] > 0;
    grid.scale[k] = own ? cloud.scale[k] : scale_m;
    grid.offset[k] = whole_offset(cloud.origin[k], grid.scale[k]);
  }
  return grid;
}

RecordEncoder::RecordEncoder(const PointCloud& cloud, const Grid& grid, bool legacy, bool extra_bytes, bool gps_time)
    : cloud_(cloud), grid_(grid), legacy_(legacy), gps_time_(gps_time) {
  const bool colour = cloud.has(arrays::red) || cloud.has(arrays::green) || cloud.has(arrays::blue);
  const bool infrared = cloud.has(arrays::near_infrared);
  format_ = legacy ? (colour ? 3 : 1) : infrared ? 8 : colour ? 7 : 6;
  layout_ = las::point_layout(format_);
  record_length_ = static_cast<std::size_t>(layout_.size);
  place_origin();
  if (!extra_bytes) return;
  for (const auto& [name, column] : cloud.columns()) {
    if (has_field(name, layout_) && (gps_time || name != arrays::time.name)) continue;
    ExtraDimension dimension;
    dimension.name = name;
    dimension.type = sensor_axis(name) >= 0 ? ExtraType::f64 : extra_type(*column);
    const auto* known = find_array(name);
    if (known != nullptr) dimension.description = std::string(unit_symbol(known->unit));
    dimension.offset = record_length_;
    if (name.size() > 32 || record_length_ + extra_type_size(dimension.type) > 65535 ||
        (dimensions_.size() + 1) * extra_descriptor_size > 65535) {
      left_out_.push_back(name);
      continue;
    }
    record_length_ += extra_type_size(dimension.type);
    dimensions_.push_back(std::move(dimension));
  }
}

void RecordLosses::add(const RecordLosses& other) {
  for (const auto& [name, count] : other.held) held[name] += count;
  for (const auto& [name, count] : other.rounded) rounded[name] += count;
}

template <class T>
void RecordEncoder::encode_field(const char* name, std::size_t place, const PointList& points, std::uint8_t* records,
                                 RecordLosses& losses, double per_unit, double low, double high) const {
  const auto it = cloud_.columns().find(name);
  if (it == cloud_.columns().end()) return;
  if (low >= high) {
    low = std::numeric_limits<T>::min();
    high = std::numeric_limits<T>::max();
  }
  std::size_t fractions = 0;
  std::visit(
      [&](const auto& values) {
        using From = typename std::decay_t<decltype(values)>::value_type;
        std::uint8_t* at = records + place;
        for (std::size_t i = 0; i < points.count; ++i, at += record_length_) {
          if constexpr (std::is_same_v<From, T>)
            store(at, values[points[i]]);
          else {
            const double value = held(name, static_cast<double>(values[points[i]]) * per_unit, low, high, losses),
                         whole = std::round(value);
            if (whole != value) ++fractions;
            store(at, static_cast<T>(whole));
          }
        }
      },
      *it->second);
  // Scan angles are steps of their own unit; elsewhere a fraction is lost.
  if (fractions > 0 && std::string_view(name) != arrays::scan_angle.name) losses.rounded[name] += fractions;
}

void RecordEncoder::encode(const PointList& points, std::uint8_t* records, RecordLosses& losses) const {
  namespace fl = field::legacy;
  namespace fe = field::extended;
  for (std::size_t i = 0; i < points.count; ++i) {
    const auto at = steps(points[i]);
    std::memcpy(records + i * record_length_, at.data(), sizeof at);
  }
  encode_field<std::uint16_t>("intensity", field::intensity, points, records, losses);
  encode_returns(points, records, losses);
  if (legacy_) {
    encode_field<std::int8_t>("scan_angle", fl::scan_angle, points, records, losses, 1, -90, 90);
    encode_field<std::uint8_t>("user_data", fl::user_data, points, records, losses);
    encode_field<std::uint16_t>("point_source_id", fl::point_source_id, points, records, losses);
  } else {
    encode_field<std::uint8_t>("classification", fe::classification, points, records, losses);
    encode_field<std::int16_t>("scan_angle", fe::scan_angle, points, records, losses, 1 / scan_angle_step_deg, -32768,
                               32767);
    encode_field<std::uint8_t>("user_data", fe::user_data, points, records, losses);
    encode_field<std::uint16_t>("point_source_id", fe::point_source_id, points, records, losses);
  }
  encode_flags(points, records, losses);
  if (const auto* info = &arrays::time; gps_time_ && cloud_.has(*info)) {
    const Column& column = cloud_.column(info->name);
    for (std::size_t i = 0; i < points.count; ++i)
      store(records + i * record_length_ + static_cast<std::size_t>(layout_.time), column_value(column, points[i]));
  }
  if (layout_.colour >= 0) {
    const auto place = static_cast<std::size_t>(layout_.colour);
    encode_field<std::uint16_t>("red", place, points, records, losses);
    encode_field<std::uint16_t>("green", place + 2, points, records, losses);
    encode_field<std::uint16_t>("blue", place + 4, points, records, losses);
  }
  if (layout_.near_infrared >= 0)
    encode_field<std::uint16_t>("near_infrared", static_cast<std::size_t>(layout_.near_infrared), points, records,
                                losses);
  encode_extra(points, records);
}

// The origin's own place on the grid is a whole number of steps for a cloud that came from a file; each offset is
// rounded by itself then, so that the large origin cannot push it to a neighbouring step.
void RecordEncoder::place_origin() {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    origin_steps_[k] = (cloud_.origin[axis] - grid_.offset[axis]) / grid_.scale[axis];
    on_grid_[k] = cloud_.scale[axis] > 0 && std::abs(origin_steps_[k] - std::round(origin_steps_[k])) < 1e-5;
    if (on_grid_[k]) origin_steps_[k] = std::round(origin_steps_[k]);
  }
}

std::array<std::int32_t, 3> RecordEncoder::steps(std::size_t point) const {
  std::array<std::int32_t, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double steps = static_cast<double>(cloud_.positions()[point][axis]) / grid_.scale[axis];
    const double whole = on_grid_[k] ? std::round(steps) + origin_steps_[k] : std::round(steps + origin_steps_[k]);
    if (!(std::abs(whole) <= 2147483647.0))
      throw bad_input(
          fmt::format("point {} has the coordinate {} on axis {}", point, cloud_.position(point)[axis], "xyz"[k]),
          fmt::format("finite coordinates within {:.0f} m of {}", 2147483647.0 * grid_.scale[axis], grid_.offset[axis]),
          "Remove the point, or write with a coarser scale");
    out[k] = static_cast<std::int32_t>(whole);
  }
  return out;
}

void RecordEncoder::encode_returns(const PointList& points, std::uint8_t* records, RecordLosses& losses) const {
  const unsigned most = legacy_ ? 7 : 15, shift = legacy_ ? 3 : 4;
  const auto column = [&](const ArrayInfo& info) { return cloud_.has(info) ? &cloud_.column(info.name) : nullptr; };
  const Column* number = column(arrays::return_number);
  const Column* of = column(arrays::number_of_returns);
  for (std::size_t i = 0; i < points.count; ++i) {
    const double r = number != nullptr ? column_value(*number, points[i]) : 1,
                 n = of != nullptr ? column_value(*of, points[i]) : 1;
    const auto r_bits = static_cast<unsigned>(held("return_number", r, 0, most, losses)),
               n_bits = static_cast<unsigned>(held("number_of_returns", n, 0, most, losses));
    records[i * record_length_ + field::returns] = static_cast<std::uint8_t>(r_bits | n_bits << shift);
  }
}

void RecordEncoder::encode_flags(const PointList& points, std::uint8_t* records, RecordLosses& losses) const {
  namespace fl = field::legacy;
  if (legacy_ && cloud_.has(arrays::classification)) {
    const Column& classes = cloud_.column(arrays::classification.name);
    for (std::size_t i = 0; i < points.count; ++i) {
      // Five bits; what they cannot hold becomes class 1, unassigned.
      double value = column_value(classes, points[i]);
      if (!(value >= 0 && value <= 31)) {
        ++losses.held["classification"];
        value = 1;
      }
      records[i * record_length_ + fl::classification] = static_cast<std::uint8_t>(value);
    }
  }
  for (const auto& flag : flag_columns) {
    const auto it = cloud_.columns().find(flag.name);
    if (it == cloud_.columns().end() || !has_field(flag.name, layout_)) continue;
    const std::size_t place = !legacy_ ? field::extended::flags : flag.shift < 3 ? fl::classification : field::returns;
    const unsigned shift = legacy_ && flag.shift < 3 ? flag.shift + 5 : flag.shift;
    for (std::size_t i = 0; i < points.count; ++i) {
      const auto value =
          static_cast<unsigned>(held(flag.name, column_value(*it->second, points[i]), 0, flag.mask, losses));
      records[i * record_length_ + place] |= static_cast<std::uint8_t>(value << shift);
    }
  }
}

void RecordEncoder::encode_extra(const PointList& points, std::uint8_t* records) const {
  for (const auto& dimension : dimensions_) {
    const int axis = sensor_axis(dimension.name);
    std::visit(
        [&](const auto& values) {
          std::uint8_t* at = records + dimension.offset;
          for (std::size_t i = 0; i < points.count; ++i, at += record_length_) {
            if (axis >= 0)
              // Rounded, so that reading it into another origin and writing it again gives the same number.
              store(at, std::round((cloud_.origin[axis] + static_cast<double>(values[points[i]])) * 1e4) / 1e4);
            else
              store(at, values[points[i]]);
          }
        },
        cloud_.column(dimension.name));
  }
}

std::vector<std::string> RecordEncoder::warnings(const RecordLosses& losses) const {
  std::vector<std::string> out;
  for (const auto& name : left_out_)
    out.push_back(fmt::format("array {} has a name or size that LAS extra bytes cannot hold; it is left out", name));
  for (const auto& [name, count] : losses.held)
    out.push_back(fmt::format("{} values of {} do not fit the LAS field and are held at its ends", count, name));
  for (const auto& [name, count] : losses.rounded)
    out.push_back(
        fmt::format("{} values of {} are rounded to whole numbers, as the LAS field holds them", count, name));
  return out;
}

}  // namespace bole::io::las
