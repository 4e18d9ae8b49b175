#include "io/core/las/las_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/las/crs_geokeys.h"
#include "io/core/las/las_extra_bytes.h"
#include "io/core/las/las_format.h"

namespace bole::io {

namespace las {

namespace {

constexpr std::size_t header_size_1_2 = 227, header_size_1_3 = 235, header_size_1_4 = 375;
constexpr std::size_t vlr_header_size = 54, evlr_header_size = 60;

Eigen::Vector3d load_vector(const std::uint8_t* at) {
  return {load<double>(at), load<double>(at + 8), load<double>(at + 16)};
}

void read_identity(Bytes file, LasInfo& info) {
  if (file.size() < 4 || std::memcmp(file.data(), "LASF", 4) != 0)
    throw bad_input("the file does not begin with LASF", "a LAS or LAZ file");
  if (file.size() < header_size_1_2)
    throw bad_input(fmt::format("the file ends after {} bytes, within the LAS header", file.size()),
                    fmt::format("{} bytes of header", header_size_1_2), "The file was cut: copy it again");
  const std::uint8_t* h = file.data();
  info.file_source_id = load<std::uint16_t>(h + 4);
  info.global_encoding = load<std::uint16_t>(h + 6);
  info.version_major = h[24];
  info.version_minor = h[25];
  if (info.version_major != 1 || info.version_minor > 4)
    throw bad_input(fmt::format("LAS version {}.{}", info.version_major, info.version_minor), "1.0 to 1.4");
  info.system = load_text(h + 26, 32);
  info.software = load_text(h + 58, 32);
  info.creation_day = load<std::uint16_t>(h + 90);
  info.creation_year = load<std::uint16_t>(h + 92);
}

void read_layout(Bytes file, LasInfo& info) {
  const std::uint8_t* h = file.data();
  const std::size_t needed = info.version_minor >= 4   ? header_size_1_4
                             : info.version_minor == 3 ? header_size_1_3
                                                       : header_size_1_2;
  const std::size_t header_size = load<std::uint16_t>(h + 94);
  if (header_size < needed || header_size > file.size())
    throw bad_input(fmt::format("the header of LAS 1.{} has {} bytes (file: {} bytes)", info.version_minor, header_size,
                                file.size()),
                    fmt::format("at least {} and no more than the file", needed));
  info.data_offset = load<std::uint32_t>(h + 96);
  if (info.data_offset < header_size || info.data_offset > file.size())
    throw bad_input(fmt::format("the points begin at byte {}", info.data_offset),
                    fmt::format("a place between the header ({} bytes) and the end of the file ({} bytes)", header_size,
                                file.size()));
  info.compressed = (h[104] & 0x80) != 0;
  info.point_format = h[104] & 0x3f;
  if (info.point_format > max_point_format)
    throw bad_input(fmt::format("point format {}", info.point_format), "0 to 10");
  info.record_length = load<std::uint16_t>(h + 105);
  if (info.record_length < point_layout(info.point_format).size)
    throw bad_input(
        fmt::format("point records of {} bytes", info.record_length),
        fmt::format("at least {} for point format {}", point_layout(info.point_format).size, info.point_format));
}

void read_extent(Bytes file, LasInfo& info) {
  const std::uint8_t* h = file.data();
  info.scale = load_vector(h + 131);
  info.offset = load_vector(h + 155);
  if (!info.scale.allFinite() || (info.scale.array() == 0).any() || !info.offset.allFinite())
    throw bad_input(fmt::format("coordinate scale {} {} {} and offset {} {} {}", info.scale.x(), info.scale.y(),
                                info.scale.z(), info.offset.x(), info.offset.y(), info.offset.z()),
                    "finite numbers, scales other than zero");
  constexpr double largest_scale = 1000, smallest_scale = 1e-12;  // units of the file per step
  const Eigen::Array3d size = info.scale.array().abs();
  if (size.maxCoeff() > largest_scale || size.minCoeff() < smallest_scale)
    throw bad_input(fmt::format("coordinate scale {} {} {}", info.scale.x(), info.scale.y(), info.scale.z()),
                    fmt::format("scales from {} to {}", smallest_scale, largest_scale),
                    "The header is damaged: copy the file again");
  if (info.scale.minCoeff() < 0)
    info.warnings.push_back(
        fmt::format("the coordinate scale {} {} {} is negative: check that the cloud is not mirrored", info.scale.x(),
                    info.scale.y(), info.scale.z()));
  info.max = {load<double>(h + 179), load<double>(h + 195), load<double>(h + 211)};
  info.min = {load<double>(h + 187), load<double>(h + 203), load<double>(h + 219)};
  if (!info.min.allFinite() || !info.max.allFinite() || (info.min.array() > info.max.array()).any())
    info.warnings.push_back("the bounding box of the header is not one; that of the points is used");
}

void read_counts(Bytes file, LasInfo& info) {
  const std::uint8_t* h = file.data();
  const std::uint64_t legacy = load<std::uint32_t>(h + 107);
  info.points = legacy;
  for (std::size_t i = 0; i < 5; ++i) info.points_by_return[i] = load<std::uint32_t>(h + 111 + 4 * i);
  if (info.version_minor < 4) return;
  const auto extended = load<std::uint64_t>(h + 247);
  if (extended != 0) {
    info.points = extended;
    for (std::size_t i = 0; i < 15; ++i) info.points_by_return[i] = load<std::uint64_t>(h + 255 + 8 * i);
  }
  if (legacy != 0 && legacy != extended) {
    // Of two counts that disagree, the one that the file can hold.
    const std::uint64_t room = (file.size() - info.data_offset) / static_cast<std::uint64_t>(info.record_length);
    if (!info.compressed && extended > room && legacy <= room) info.points = legacy;
    info.warnings.push_back(
        fmt::format("the header counts {} points in its legacy field and {} in its extended one; {} is used", legacy,
                    extended, info.points));
  }
}

// Adds the records from `at` on; those that do not lie within [at, end) are left out with a warning.
void read_vlrs(Bytes file, std::uint64_t at, std::uint64_t end, std::uint64_t count, bool extended, LasInfo& info) {
  const std::size_t head = extended ? evlr_header_size : vlr_header_size;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (end < at || end - at < head) {
      info.warnings.push_back(
          fmt::format("{} of {} {}variable length records lie within the file", i, count, extended ? "extended " : ""));
      return;
    }
    const std::uint8_t* h = file.data() + at;
    LasVlr vlr;
    vlr.extended = extended;
    vlr.user_id = load_text(h + 2, 16);
    vlr.record_id = load<std::uint16_t>(h + 18);
    vlr.length = extended ? load<std::uint64_t>(h + 20) : load<std::uint16_t>(h + 20);
    vlr.description = load_text(h + (extended ? 28 : 22), 32);
    vlr.offset = at + head;
    if (vlr.length > end - vlr.offset) {
      info.warnings.push_back(
          fmt::format("variable length record {} of {} ({} {}) says it has {} bytes, {} are there; it and those behind "
                      "it are left out",
                      i + 1, count, vlr.user_id, vlr.record_id, vlr.length, end - vlr.offset));
      return;
    }
    at = vlr.offset + vlr.length;
    info.vlrs.push_back(std::move(vlr));
  }
}

void read_all_vlrs(Bytes file, LasInfo& info) {
  const std::uint8_t* h = file.data();
  read_vlrs(file, load<std::uint16_t>(h + 94), info.data_offset, load<std::uint32_t>(h + 100), false, info);
  info.data_end = file.size();
  if (info.version_minor < 4) return;
  const auto first = load<std::uint64_t>(h + 235);
  const auto count = load<std::uint32_t>(h + 243);
  if (count == 0) return;
  if (first < info.data_offset || first > file.size()) {
    info.warnings.push_back(fmt::format(
        "the extended variable length records would begin at byte {} of {}; they are left out", first, file.size()));
    return;
  }
  info.data_end = first;
  read_vlrs(file, first, file.size(), count, true, info);
}

std::string crs_of(Bytes file, const LasInfo& info, bool with_crs) {
  if (const auto* wkt = find_vlr(info, "LASF_Projection", 2112)) {
    std::string text = load_text(vlr_data(file, *wkt).data(), wkt->length);
    if (!text.empty()) return text;
  }
  const auto* directory = find_vlr(info, "LASF_Projection", 34735);
  if (directory == nullptr || !with_crs) return {};
  const auto data = [&](int id) {
    const auto* vlr = find_vlr(info, "LASF_Projection", id);
    return vlr == nullptr ? Bytes{} : vlr_data(file, *vlr);
  };
  return wkt_from_geokeys(vlr_data(file, *directory), data(34736), data(34737));
}

}  // namespace

const LasVlr* find_vlr(const LasInfo& info, std::string_view user_id, int record_id) {
  const auto it = std::ranges::find_if(
      info.vlrs, [&](const LasVlr& v) { return v.user_id == user_id && v.record_id == record_id; });
  return it == info.vlrs.end() ? nullptr : &*it;
}

LasInfo parse_info(Bytes file, bool with_crs) {
  LasInfo info;
  read_identity(file, info);
  read_layout(file, info);
  read_extent(file, info);
  read_counts(file, info);
  read_all_vlrs(file, info);
  info.crs_wkt = crs_of(file, info, with_crs);
  if (with_crs) {
    if (const std::string text = unit_warning(info.crs_wkt); !text.empty()) info.warnings.push_back(text);
  }
  for (const auto& dimension : extra_dimensions(file, info, info.warnings))
    info.extra_columns.push_back(dimension.name);
  return info;
}

}  // namespace las

LasInfo las_info(const std::filesystem::path& path) {
  const MappedFile file(path);
  try {
    return las::parse_info(file.bytes());
  } catch (const Error& error) {
    throw error.at(path.string());
  }
}

}  // namespace bole::io
