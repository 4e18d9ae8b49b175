#include "io/core/las/las_extra_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/core/las/las_format.h"

namespace bole::io::las {

namespace {

constexpr unsigned has_no_data = 1, has_scale = 8, has_offset = 16;

// Calls f with a value of the C++ type of `type`.
template <class F>
void with_type(ExtraType type, F&& f) {
  switch (type) {
    case ExtraType::u8:
      return f(std::uint8_t{});
    case ExtraType::i8:
      return f(std::int8_t{});
    case ExtraType::u16:
      return f(std::uint16_t{});
    case ExtraType::i16:
      return f(std::int16_t{});
    case ExtraType::u32:
      return f(std::uint32_t{});
    case ExtraType::i32:
      return f(std::int32_t{});
    case ExtraType::u64:
      return f(std::uint64_t{});
    case ExtraType::i64:
      return f(std::int64_t{});
    case ExtraType::f32:
      return f(float{});
    case ExtraType::f64:
      return f(double{});
  }
}

// Integers are clamped to the range of the target, and NaN becomes zero, because other conversions are undefined in
// C++ and a hostile file could reach them.
template <class To>
To converted(double value) {
  if constexpr (std::is_floating_point_v<To>) {
    return static_cast<To>(value);
  } else {
    if (!(value == value)) return 0;
    return static_cast<To>(std::clamp<double>(value, std::numeric_limits<To>::min(), std::numeric_limits<To>::max()));
  }
}

// Some writers give the value of a float as a double that no float is equal to.
template <class T>
bool is_no_data(T stored, double no_data) {
  return static_cast<double>(stored) == no_data ||
         (std::is_same_v<T, float> && std::abs(no_data) <= std::numeric_limits<float>::max() &&
          static_cast<float>(stored) == static_cast<float>(no_data));
}

// A number of the descriptor: 8 bytes, whole or not as the values are.
double stored_number(ExtraType type, const std::uint8_t* at) {
  if (type == ExtraType::f32 || type == ExtraType::f64) return load<double>(at);
  const bool is_signed =
      type == ExtraType::i8 || type == ExtraType::i16 || type == ExtraType::i32 || type == ExtraType::i64;
  return is_signed ? static_cast<double>(load<std::int64_t>(at)) : static_cast<double>(load<std::uint64_t>(at));
}

}  // namespace

int sensor_axis(std::string_view name) {
  return name == arrays::sensor_x.name ? 0 : name == arrays::sensor_y.name ? 1 : name == arrays::sensor_z.name ? 2 : -1;
}

std::size_t extra_type_size(ExtraType type) {
  std::size_t size = 0;
  with_type(type, [&](auto v) { size = sizeof v; });
  return size;
}

ArrayType ExtraDimension::column_type() const {
  if (const auto* known = find_array(name)) return known->type;
  if (is_flag_column(name)) return ArrayType::uint8;
  if (scaled) return ArrayType::float64;
  // Only floats can say that a value is missing.
  if (no_data) return extra_type_size(type) <= 2 || type == ExtraType::f32 ? ArrayType::float32 : ArrayType::float64;
  switch (type) {
    case ExtraType::u8:
      return ArrayType::uint8;
    case ExtraType::u16:
      return ArrayType::uint16;
    case ExtraType::i8:
    case ExtraType::i16:
    case ExtraType::i32:
      return ArrayType::int32;
    case ExtraType::f32:
      return ArrayType::float32;
    default:
      return ArrayType::float64;
  }
}

std::vector<ExtraDimension> extra_dimensions(Bytes file, const LasInfo& info, std::vector<std::string>& warnings) {
  std::vector<ExtraDimension> out;
  const auto* vlr = find_vlr(info, "LASF_Spec", 4);
  if (vlr == nullptr) return out;
  const Bytes data = vlr_data(file, *vlr);
  auto at = static_cast<std::size_t>(point_layout(info.point_format).size);
  for (std::size_t i = 0; (i + 1) * extra_descriptor_size <= data.size(); ++i) {
    const std::uint8_t* d = data.data() + i * extra_descriptor_size;
    const unsigned type = d[2], options = d[3];
    ExtraDimension dimension;
    dimension.name = load_text(d + 4, 32);
    dimension.description = load_text(d + 160, 32);
    dimension.offset = at;
    const bool scalar = type >= 1 && type <= 10;
    // Types 11 to 30 are pairs and triples of the scalar types, 0 is a run of `options` bytes.
    const std::size_t elements = type == 0 ? options : type <= 30 ? (type - 1) / 10 + 1 : 0;
    const std::size_t size =
        type == 0 ? elements
                  : elements * (type <= 30 ? extra_type_size(static_cast<ExtraType>((type - 1) % 10 + 1)) : 0);
    at += size;
    if (type > 30 || at > static_cast<std::size_t>(info.record_length)) {
      warnings.push_back(fmt::format(
          "extra bytes '{}' (type {}) do not lie within the point record; they and those after them are skipped",
          dimension.name, type));
      break;
    }
    if (!scalar) {
      warnings.push_back(fmt::format("extra bytes '{}' are not a single number and are skipped", dimension.name));
      continue;
    }
    if (dimension.name.empty() || std::ranges::find(out, dimension.name, &ExtraDimension::name) != out.end()) {
      warnings.push_back(fmt::format("extra bytes {} have no unique name and are skipped", i + 1));
      continue;
    }
    dimension.type = static_cast<ExtraType>(type);
    if ((options & has_no_data) != 0) dimension.no_data = stored_number(dimension.type, d + 40);
    if ((options & has_scale) != 0) {
      dimension.scaled = true;
      dimension.scale = load<double>(d + 112);
    }
    if ((options & has_offset) != 0) {
      dimension.scaled = true;
      dimension.shift = load<double>(d + 136);
    }
    out.push_back(std::move(dimension));
  }
  return out;
}

void decode_extra(const ExtraDimension& dimension, const std::uint8_t* records, std::size_t stride, std::size_t count,
                  Column& column, std::size_t first) {
  std::visit(
      [&](auto& values) {
        using To = typename std::decay_t<decltype(values)>::value_type;
        with_type(dimension.type, [&](auto sample) {
          using From = decltype(sample);
          const std::uint8_t* at = records + dimension.offset;
          for (std::size_t i = 0; i < count; ++i, at += stride) {
            const From stored = load<From>(at);
            if constexpr (std::is_same_v<From, To>) {
              if (!dimension.scaled && !dimension.no_data) {
                values[first + i] = stored;
                continue;
              }
            }
            const auto value = static_cast<double>(stored);
            if (dimension.no_data && is_no_data(stored, *dimension.no_data)) {
              values[first + i] = converted<To>(std::numeric_limits<double>::quiet_NaN());
              continue;
            }
            values[first + i] = converted<To>(dimension.scaled ? value * dimension.scale + dimension.shift : value);
          }
        });
      },
      column);
}

void store_descriptor(const ExtraDimension& dimension, std::uint8_t* at) {
  std::memset(at, 0, extra_descriptor_size);
  at[2] = static_cast<std::uint8_t>(dimension.type);
  at[3] = static_cast<std::uint8_t>(dimension.scaled ? has_scale | has_offset : 0U);
  store_text(at + 4, 32, dimension.name);
  if (dimension.scaled) {
    store(at + 112, dimension.scale);
    store(at + 136, dimension.shift);
  }
  store_text(at + 160, 32, dimension.description);
}

}  // namespace bole::io::las
