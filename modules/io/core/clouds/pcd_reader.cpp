#include "io/core/clouds/pcd_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

constexpr std::size_t max_fields = 256, max_values = 4096;

struct Field {
  SourceField source;
  std::size_t bytes = 4, count = 1;
  char type = 'F';
};

struct PcdHeader {
  std::vector<Field> fields;
  std::uint64_t width = 0, height = 1;
  std::optional<std::uint64_t> points;
  std::string data;
  std::size_t data_offset = 0;

  // Nothing where width times height overflows.
  std::uint64_t declared() const {
    if (points) return *points;
    return height != 0 && width > UINT64_MAX / height ? UINT64_MAX : width * height;
  }
  std::size_t record_bytes() const {
    std::size_t sum = 0;
    for (const auto& f : fields) sum += f.bytes * f.count;
    return sum;
  }
  std::size_t numbers() const {
    std::size_t sum = 0;
    for (const auto& f : fields) sum += f.count;
    return sum;
  }
};

SourceType source_type(const Field& f) {
  const bool colour = f.source.name == "rgb" || f.source.name == "rgba";
  if (colour && f.bytes == 4) return SourceType::packed_rgb;
  const auto wrong = bad_input("PCD field '" + f.source.name + "' has type " + std::string(1, f.type) + " of " +
                                   std::to_string(f.bytes) + " bytes",
                               "F of 4 or 8, I or U of 1, 2, 4 or 8 bytes");
  if (f.type == 'F') {
    if (f.bytes != 4 && f.bytes != 8) throw wrong;
    return f.bytes == 4 ? SourceType::float32 : SourceType::float64;
  }
  const bool is_signed = f.type == 'I';
  if (!is_signed && f.type != 'U') throw wrong;
  switch (f.bytes) {
    case 1:
      return is_signed ? SourceType::int8 : SourceType::uint8;
    case 2:
      return is_signed ? SourceType::int16 : SourceType::uint16;
    case 4:
      return is_signed ? SourceType::int32 : SourceType::uint32;
    case 8:
      return is_signed ? SourceType::int64 : SourceType::uint64;
    default:
      throw wrong;
  }
}

template <class T>
T whole_number(std::string_view word, std::string_view key) {
  T value{};
  if (!parse_number(word, value))
    throw bad_input("PCD header: " + std::string(key) + " has '" + std::string(word.substr(0, 40)) + "'",
                    "a whole number");
  return value;
}

void read_header_line(const std::vector<std::string_view>& words, PcdHeader& header) {
  const auto key = words[0];
  const auto check_count = [&] {
    if (words.size() - 1 != header.fields.size())
      throw bad_input("PCD header: " + std::string(key) + " has " + std::to_string(words.size() - 1) + " entries",
                      std::to_string(header.fields.size()) + ", one per field");
  };
  if (key == "FIELDS" || key == "COLUMNS") {
    if (words.size() - 1 > max_fields)
      throw bad_input("PCD header: " + std::to_string(words.size() - 1) + " fields",
                      "at most " + std::to_string(max_fields));
    header.fields.assign(words.size() - 1, {});
    for (std::size_t i = 1; i < words.size(); ++i) header.fields[i - 1].source.name = words[i];
  } else if (key == "SIZE") {
    check_count();
    for (std::size_t i = 1; i < words.size(); ++i)
      header.fields[i - 1].bytes = whole_number<std::uint8_t>(words[i], key);
  } else if (key == "TYPE") {
    check_count();
    for (std::size_t i = 1; i < words.size(); ++i) header.fields[i - 1].type = words[i][0];
  } else if (key == "COUNT") {
    check_count();
    for (std::size_t i = 1; i < words.size(); ++i)
      header.fields[i - 1].count = whole_number<std::uint16_t>(words[i], key);
  } else if (words.size() > 1 && key == "WIDTH") {
    header.width = whole_number<std::uint64_t>(words[1], key);
  } else if (words.size() > 1 && key == "HEIGHT") {
    header.height = whole_number<std::uint64_t>(words[1], key);
  } else if (words.size() > 1 && key == "POINTS") {
    header.points = whole_number<std::uint64_t>(words[1], key);
  } else if (words.size() > 1 && key == "DATA") {
    header.data = words[1];
  }
}

PcdHeader read_pcd_header(Bytes file) {
  PcdHeader header;
  LineReader lines(file);
  std::string_view line;
  while (header.data.empty()) {
    if (!lines.next(line))
      throw bad_input("the PCD header has no line DATA after " + std::to_string(lines.number()) + " lines",
                      "DATA ascii, binary or binary_compressed");
    const auto words = split_blanks(line);
    if (!words.empty() && !words[0].starts_with('#')) read_header_line(words, header);
  }
  header.data_offset = lines.position();
  for (auto& f : header.fields) f.source.type = source_type(f);
  if (header.numbers() > max_values)
    throw bad_input("the PCD header names " + std::to_string(header.numbers()) + " values per point",
                    "at most " + std::to_string(max_values));
  return header;
}

// One field per value. Values of a field with a count above 1 get numbered names.
std::vector<SourceField> flat_fields(const PcdHeader& header) {
  std::vector<SourceField> fields;
  for (const auto& f : header.fields)
    for (std::size_t i = 0; i < f.count; ++i) {
      auto field = f.source;
      if (f.count > 1) field.name += "_" + std::to_string(i);
      fields.push_back(std::move(field));
    }
  return fields;
}

// A colour written as a decimal number is the bit pattern of a float.
double ascii_value(const SourceField& field, char type, std::string_view word) {
  double value = 0;
  if (!parse_number(word, value)) return std::nan("");
  if (field.type == SourceType::packed_rgb && type == 'F')
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  // An opaque colour is negative when it is read as a signed number.
  if (field.type == SourceType::packed_rgb && type == 'I' && value < 0) return value + 4294967296.0;
  return value;
}

CloudReading read_ascii_pcd(Bytes data, const PcdHeader& header, const CloudReadOptions& options, const Run& run) {
  const auto fields = flat_fields(header);
  CloudBuilder builder(fields, options);
  std::vector<char> types;
  for (const auto& f : header.fields) types.insert(types.end(), f.count, f.type);
  std::vector<double> row(fields.size());
  std::vector<std::string_view> words;
  LineReader lines(data);
  std::string_view line;
  std::size_t read = 0, bad = 0;
  while (read < header.declared() && lines.next(line)) {
    poll_points(run, lines.number(), 0);
    split_blanks(line, words);
    if (words.empty()) continue;
    ++read;
    if (words.size() < fields.size()) {
      ++bad;
      continue;
    }
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = ascii_value(fields[i], types[i], words[i]);
    builder.add(row);
  }
  auto out = builder.finish();
  out.report.counts["bad_lines"] = static_cast<std::int64_t>(bad);
  if (bad > 0)
    out.report.warn(std::to_string(bad) + " lines with fewer than " + std::to_string(fields.size()) +
                    " values were skipped");
  warn_cut_off(out.report, header.declared(), read);
  return out;
}

CloudReading read_binary_pcd(Bytes data, const PcdHeader& header, const CloudReadOptions& options, const Run& run) {
  const auto fields = flat_fields(header);
  CloudBuilder builder(fields, options);
  const std::size_t record = header.record_bytes();
  const auto present = static_cast<std::size_t>(std::min<std::uint64_t>(header.declared(), data.size() / record));
  builder.reserve(present);
  std::vector<double> row(fields.size());
  for (std::size_t i = 0; i < present; ++i) {
    poll_points(run, i, static_cast<double>(i) / static_cast<double>(present));
    const std::uint8_t* p = data.data() + i * record;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      row[f] = source_value(fields[f].type, p);
      p += source_type_bytes(fields[f].type);
    }
    builder.add(row);
  }
  auto out = builder.finish();
  warn_cut_off(out.report, header.declared(), present);
  return out;
}

// Compressed data is stored field by field.
CloudReading read_compressed(Bytes data, const PcdHeader& header, const CloudReadOptions& options, const Run& run) {
  const auto fields = flat_fields(header);
  CloudBuilder builder(fields, options);
  if (data.size() < 8)
    throw bad_input("the compressed PCD data has " + std::to_string(data.size()) + " bytes",
                    "two sizes of 4 bytes and the data");
  const auto packed = static_cast<std::size_t>(source_value(SourceType::uint32, data.data()));
  const auto unpacked = static_cast<std::size_t>(source_value(SourceType::uint32, data.data() + 4));
  const std::size_t record = header.record_bytes();
  const std::uint64_t declared = header.declared();
  if (packed > data.size() - 8)
    throw bad_input("the file is cut off: compressed PCD data of " + std::to_string(packed) + " bytes, " +
                        std::to_string(data.size() - 8) + " are there",
                    "the whole file", "Compressed PCD data cannot be read in part: copy the file again");
  if (declared > unpacked / record || declared * record != unpacked)
    throw bad_input(
        "compressed PCD data of " + std::to_string(unpacked) + " bytes for " + std::to_string(declared) + " points",
        std::to_string(record) + " bytes per point");
  const auto bytes = lzf_unpack(data.subspan(8, packed), unpacked);
  const auto points = static_cast<std::size_t>(declared);
  builder.reserve(points);
  std::vector<double> row(fields.size());
  for (std::size_t i = 0; i < points; ++i) {
    poll_points(run, i, static_cast<double>(i) / static_cast<double>(points));
    std::size_t column = 0, flat = 0;
    for (const auto& f : header.fields) {
      for (std::size_t k = 0; k < f.count; ++k, ++flat)
        row[flat] = source_value(f.source.type, bytes.data() + column + (i * f.count + k) * f.bytes);
      column += points * f.bytes * f.count;
    }
    builder.add(row);
  }
  return builder.finish();
}

}  // namespace

bool looks_like_pcd(Bytes file) {
  const std::string_view head(reinterpret_cast<const char*>(file.data()), std::min<std::size_t>(file.size(), 2048));
  return head.starts_with("# .PCD") ||
         ((head.starts_with("VERSION") || head.starts_with("FIELDS") || head.starts_with('#')) &&
          head.find("\nFIELDS ") != std::string_view::npos && head.find("\nDATA ") != std::string_view::npos);
}

std::vector<std::uint8_t> lzf_unpack(Bytes packed, std::size_t size) {
  const auto wrong = [](const char* what) {
    return bad_input(std::string("the compressed PCD data is damaged: ") + what, "LZF data");
  };
  // Three packed bytes give at most 264 bytes.
  if (size > packed.size() * 88 + 264) throw wrong("it claims to unpack to more than it can");
  std::vector<std::uint8_t> out;
  out.reserve(size);
  std::size_t i = 0;
  while (i < packed.size()) {
    const std::size_t control = packed[i++];
    if (control < 32) {
      const std::size_t run = control + 1;
      if (run > packed.size() - i || run > size - out.size()) throw wrong("a run goes beyond the end");
      out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(i),
                 packed.begin() + static_cast<std::ptrdiff_t>(i + run));
      i += run;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) {
      if (i >= packed.size()) throw wrong("it ends within a length");
      length += packed[i++];
    }
    length += 2;
    if (i >= packed.size()) throw wrong("it ends within a reference");
    const std::size_t distance = ((control & 0x1F) << 8 | packed[i++]) + 1;
    if (distance > out.size() || length > size - out.size()) throw wrong("a reference goes beyond the data");
    for (std::size_t k = 0; k < length; ++k) out.push_back(out[out.size() - distance]);
  }
  if (out.size() != size) throw wrong("it unpacks to too few bytes");
  return out;
}

CloudReading read_pcd(Bytes file, const CloudReadOptions& options, const Run& run) {
  const PcdHeader header = read_pcd_header(file);
  const Bytes data = file.subspan(header.data_offset);
  if (header.fields.empty()) throw bad_input("the PCD header names no fields", "a line FIELDS x y z");
  CloudReading out;
  if (header.data == "ascii") {
    out = read_ascii_pcd(data, header, options, run);
  } else if (header.data == "binary") {
    out = read_binary_pcd(data, header, options, run);
  } else if (header.data == "binary_compressed") {
    out = read_compressed(data, header, options, run);
  } else {
    throw bad_input("PCD data is '" + header.data.substr(0, 40) + "'", "ascii, binary or binary_compressed");
  }
  out.report.facts["format"] = "PCD " + header.data;
  return out;
}

}  // namespace bole::io
