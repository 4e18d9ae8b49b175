// Extra bytes of LAS points: columns without a field in the point format (LAS 1.4 R15, "Extra Bytes", record 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/point_cloud.h"
#include "io/core/las/las_bytes.h"
#include "io/core/las/las_info.h"

namespace bole::io::las {

enum class ExtraType { u8 = 1, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

struct ExtraDimension {
  std::string name;
  std::string description;
  ExtraType type = ExtraType::f32;
  std::size_t offset = 0;  // within the point record
  bool scaled = false;     // value = stored * scale + shift
  double scale = 1, shift = 0;
  std::optional<double> no_data;  // stored where there is no value: read as NaN

  // Type of the column: that of the vocabulary for its names, else the smallest that holds the values.
  ArrayType column_type() const;
};

// 0, 1 or 2 of an array with the position of the sensor, else -1. That position is written as a global coordinate,
// because the cloud that is read back has another origin.
int sensor_axis(std::string_view name);

inline constexpr std::size_t extra_descriptor_size = 192;

std::size_t extra_type_size(ExtraType type);

// The scalar dimensions that the file describes, with a warning for each that cannot become a column (arrays, raw
// bytes, fields beyond the record, names that occur twice).
std::vector<ExtraDimension> extra_dimensions(Bytes file, const LasInfo& info, std::vector<std::string>& warnings);

// Values of `count` records of `stride` bytes into column[first, first + count).
void decode_extra(const ExtraDimension& dimension, const std::uint8_t* records, std::size_t stride, std::size_t count,
                  Column& column, std::size_t first);

// The 192 bytes of the descriptor.
void store_descriptor(const ExtraDimension& dimension, std::uint8_t* at);

}  // namespace bole::io::las
