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

int sensor_axis(std::string_view name) {
  return name == arrays::sensor_x.name ? 0 : name == arrays::sensor_y.name ? 1 : name == arrays::sensor_z.name ? 2 : -1;
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
      ++held_["array " + name];
      continue;
    }
    record_length_ += extra_type_size(dimension.type);
    dimensions_.push_back(std::move(dimension));
  }
}

double RecordEncoder::held(std::string_view name, double value, double low, double high) {
  const double inside = std::isnan(value) ? 0 : std::clamp(value, low, high);
  if (inside == value) return value;
  auto it = held_.find(name);
  if (it == held_.end()) it = held_.emplace(std::string(name), 0).first;
  ++it->second;
  return inside;
}

template <class T>
void RecordEncoder::encode_field(const char* name, std::size_t place, std::size_t first, std::size_t count,
                                 std::uint8_t* records, double per_unit, double low, double high) {
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
        for (std::size_t i = 0; i < count; ++i, at += record_length_) {
          if constexpr (std::is_same_v<From, T>)
            store(at, values[first + i]);
          else {
            const double value = held(name, static_cast<double>(values[first + i]) * per_unit, low, high),
                         whole = std::round(value);
            if (whole != value) ++fractions;
            store(at, static_cast<T>(whole));
          }
        }
      },
      *it->second);
  // Scan angles are steps of their own unit; elsewhere a fraction is lost.
  if (fractions > 0 && std::string_view(name) != arrays::scan_angle.name) rounded_[name] += fractions;
}

void RecordEncoder::encode(std::size_t first, std::size_t count, std::uint8_t* records) {
  namespace fl = field::legacy;
  namespace fe = field::extended;
  encode_positions(first, count, records);
  encode_field<std::uint16_t>("intensity", field::intensity, first, count, records);
  encode_returns(first, count, records);
  if (legacy_) {
    encode_field<std::int8_t>("scan_angle", fl::scan_angle, first, count, records, 1, -90, 90);
    encode_field<std::uint8_t>("user_data", fl::user_data, first, count, records);
    encode_field<std::uint16_t>("point_source_id", fl::point_source_id, first, count, records);
  } else {
    encode_field<std::uint8_t>("classification", fe::classification, first, count, records);
    encode_field<std::int16_t>("scan_angle", fe::scan_angle, first, count, records, 1 / scan_angle_step_deg, -32768,
                               32767);
    encode_field<std::uint8_t>("user_data", fe::user_data, first, count, records);
    encode_field<std::uint16_t>("point_source_id", fe::point_source_id, first, count, records);
  }
  encode_flags(first, count, records);
  if (const auto* info = &arrays::time; gps_time_ && cloud_.has(*info)) {
    const Column& column = cloud_.column(info->name);
    for (std::size_t i = 0; i < count; ++i)
      store(records + i * record_length_ + static_cast<std::size_t>(layout_.time), column_value(column, first + i));
  }
  if (layout_.colour >= 0) {
    const auto place = static_cast<std::size_t>(layout_.colour);
    encode_field<std::uint16_t>("red", place, first, count, records);
    encode_field<std::uint16_t>("green", place + 2, first, count, records);
    encode_field<std::uint16_t>("blue", place + 4, first, count, records);
  }
  if (layout_.near_infrared >= 0)
    encode_field<std::uint16_t>("near_infrared", static_cast<std::size_t>(layout_.near_infrared), first, count,
                                records);
  encode_extra(first, count, records);
}

void RecordEncoder::encode_positions(std::size_t first, std::size_t count, std::uint8_t* records) const {
  // The origin's own place on the grid is a whole number of steps for a cloud that came from a file; each offset is
  // rounded by itself then, so that the large origin cannot push it to a neighbouring step.
  std::array<double, 3> origin_steps{};
  std::array<bool, 3> on_grid{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    origin_steps[k] = (cloud_.origin[axis] - grid_.offset[axis]) / grid_.scale[axis];
    on_grid[k] = cloud_.scale[axis] > 0 && std::abs(origin_steps[k] - std::round(origin_steps[k])) < 1e-5;
    if (on_grid[k]) origin_steps[k] = std::round(origin_steps[k]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double steps = static_cast<double>(cloud_.positions()[first + i][axis]) / grid_.scale[axis];
      const double whole = on_grid[k] ? std::round(steps) + origin_steps[k] : std::round(steps + origin_steps[k]);
      if (!(std::abs(whole) <= 2147483647.0))
        throw bad_input(fmt::format("point {} has the coordinate {} on axis {}", first + i,
                                    cloud_.position(first + i)[axis], "xyz"[k]),
                        fmt::format("finite coordinates within {:.0f} m of {}", 2147483647.0 * grid_.scale[axis],
                                    grid_.offset[axis]),
                        "Remove the point, or write with a coarser scale");
      store(records + i * record_length_ + 4 * k, static_cast<std::int32_t>(whole));
    }
  }
}

void RecordEncoder::encode_returns(std::size_t first, std::size_t count, std::uint8_t* records) {
  const unsigned most = legacy_ ? 7 : 15, shift = legacy_ ? 3 : 4;
  const auto column = [&](const ArrayInfo& info) { return cloud_.has(info) ? &cloud_.column(info.name) : nullptr; };
  const Column* number = column(arrays::return_number);
  const Column* of = column(arrays::number_of_returns);
  for (std::size_t i = 0; i < count; ++i) {
    const double r = number != nullptr ? column_value(*number, first + i) : 1,
                 n = of != nullptr ? column_value(*of, first + i) : 1;
    const auto r_bits = static_cast<unsigned>(held("return_number", r, 0, most)),
               n_bits = static_cast<unsigned>(held("number_of_returns", n, 0, most));
    records[i * record_length_ + field::returns] = static_cast<std::uint8_t>(r_bits | n_bits << shift);
  }
}

void RecordEncoder::encode_flags(std::size_t first, std::size_t count, std::uint8_t* records) {
  namespace fl = field::legacy;
  if (legacy_ && cloud_.has(arrays::classification)) {
    const Column& classes = cloud_.column(arrays::classification.name);
    for (std::size_t i = 0; i < count; ++i) {
      // Five bits; what they cannot hold becomes class 1, unassigned.
      double value = column_value(classes, first + i);
      if (!(value >= 0 && value <= 31)) {
        ++held_["classification"];
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
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<unsigned>(held(flag.name, column_value(*it->second, first + i), 0, flag.mask));
      records[i * record_length_ + place] |= static_cast<std::uint8_t>(value << shift);
    }
  }
}

void RecordEncoder::encode_extra(std::size_t first, std::size_t count, std::uint8_t* records) const {
  for (const auto& dimension : dimensions_) {
    const int axis = sensor_axis(dimension.name);
    std::visit(
        [&](const auto& values) {
          std::uint8_t* at = records + dimension.offset;
          for (std::size_t i = 0; i < count; ++i, at += record_length_) {
            if (axis >= 0)
              // Rounded, so that reading it into another origin and writing it again gives the same number.
              store(at, std::round((cloud_.origin[axis] + static_cast<double>(values[first + i])) * 1e4) / 1e4);
            else
              store(at, values[first + i]);
          }
        },
        cloud_.column(dimension.name));
  }
}

std::vector<std::string> RecordEncoder::warnings() const {
  std::vector<std::string> out;
  for (const auto& [name, count] : held_) {
    if (name.starts_with("array "))
      out.push_back(fmt::format("{} has a name or size that LAS extra bytes cannot hold; it is left out", name));
    else
      out.push_back(fmt::format("{} values of {} do not fit the LAS field and are held at its ends", count, name));
  }
  for (const auto& [name, count] : rounded_)
    out.push_back(
        fmt::format("{} values of {} are rounded to whole numbers, as the LAS field holds them", count, name));
  return out;
}

}  // namespace bole::io::las
