#include "io/core/las/las_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/atomic_file.h"
#include "cloud/large_cloud.h"
#include "io/core/las/crs_geokeys.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_records.h"

namespace bole::io {

const OptionTable& option_table(const LasWriteOptions*) {
  using S = LasWriteOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"version",
                             &S::version,
                             TextKind::choice,
                             {"1.2", "1.4"},
                             Tier::advanced,
                             "LAS version: 1.4 holds everything, 1.2 is for older programs."},
      Option<S, double>{
          "scale_m",
          &S::scale_m,
          Unit::metre,
          {1e-6, 1.0},
          Tier::expert,
          "Step that coordinates are rounded to when the cloud does not come from a file with a grid of its own."},
      Option<S, bool>{"extra_bytes", &S::extra_bytes, Tier::advanced,
                      "Write columns without a LAS field (tree_id, height_above_ground, ...) as extra bytes."},
  });
  return table;
}

namespace {

using las::store;
using las::store_text;

struct Statistics {
  std::array<std::int32_t, 3> min{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max(),
                                  std::numeric_limits<std::int32_t>::max()};
  std::array<std::int32_t, 3> max{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min(),
                                  std::numeric_limits<std::int32_t>::min()};
  std::array<std::uint64_t, 15> by_return{};

  void add(const las::RecordEncoder& encoder, const std::uint8_t* record) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = las::load<std::int32_t>(record + 4 * k);
      min[k] = std::min(min[k], v);
      max[k] = std::max(max[k], v);
    }
    const unsigned r = encoder.return_number(record);
    if (r >= 1 && r <= by_return.size()) ++by_return[r - 1];
  }
};

void append_vlr(std::vector<std::uint8_t>& out, std::string_view user, int id, Bytes data,
                std::string_view description) {
  std::vector<std::uint8_t> head(54);
  store_text(&head[2], 16, user);
  store(&head[18], static_cast<std::uint16_t>(id));
  store(&head[20], static_cast<std::uint16_t>(data.size()));
  store_text(&head[22], 32, description);
  out.insert(out.end(), head.begin(), head.end());
  out.insert(out.end(), data.begin(), data.end());
}

std::vector<std::uint8_t> geokey_directory(int epsg) {
  const std::uint16_t geographic = 2, projected = 1;
  // Codes 4000 to 4999 are geographic systems, all others that occur in LAS files are projected ones.
  const bool degrees = epsg >= 4000 && epsg < 5000;
  const std::uint16_t keys[] = {1,
                                1,
                                0,
                                3,
                                1024,
                                0,
                                1,
                                degrees ? geographic : projected,
                                1025,
                                0,
                                1,
                                1,
                                static_cast<std::uint16_t>(degrees ? 2048 : 3072),
                                0,
                                1,
                                static_cast<std::uint16_t>(epsg)};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(keys);
  return {bytes, bytes + sizeof keys};
}

struct Vlrs {
  std::vector<std::uint8_t> bytes;
  std::uint32_t count = 0;
  void add(std::string_view user, int id, Bytes data, std::string_view description) {
    append_vlr(bytes, user, id, data, description);
    ++count;
  }
};

void add_facts(const Facts& facts, Vlrs& vlrs, std::vector<std::string>& warnings) {
  if (facts.empty()) return;
  Facts kept = facts;
  kept.erase("turned");  // the axes of the points are those of this file
  const std::string text = facts_to_json(kept);
  if (text.size() > las::max_vlr_bytes) {
    warnings.push_back(fmt::format("the facts of the cloud take {} bytes, a LAS record holds {}: they were not written",
                                   text.size(), las::max_vlr_bytes));
    return;
  }
  vlrs.add(las::facts_user, las::facts_record, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
           "facts of the cloud (JSON)");
}

Vlrs make_vlrs(const PointCloud& cloud, const las::RecordEncoder& encoder, bool legacy,
               std::vector<std::string>& warnings) {
  Vlrs vlrs;
  if (!cloud.crs_wkt.empty()) {
    const int epsg = legacy ? las::epsg_of_wkt(cloud.crs_wkt) : 0;
    if (!legacy && cloud.crs_wkt.size() < 65535) {
      // The text ends with a zero byte.
      vlrs.add("LASF_Projection", 2112,
               {reinterpret_cast<const std::uint8_t*>(cloud.crs_wkt.c_str()), cloud.crs_wkt.size() + 1},
               "OGC WKT coordinate system");
    } else if (epsg > 0 && epsg < 32767) {
      vlrs.add("LASF_Projection", 34735, geokey_directory(epsg), "GeoTIFF keys");
    } else {
      warnings.emplace_back(
          "the coordinate reference system has no EPSG code that LAS 1.2 could hold; it was not written");
    }
  }
  if (!encoder.dimensions().empty()) {
    std::vector<std::uint8_t> descriptors(encoder.dimensions().size() * las::extra_descriptor_size);
    for (std::size_t i = 0; i < encoder.dimensions().size(); ++i)
      las::store_descriptor(encoder.dimensions()[i], &descriptors[i * las::extra_descriptor_size]);
    vlrs.add("LASF_Spec", 4, descriptors, "extra bytes");
  }
  add_facts(cloud.facts, vlrs, warnings);
  return vlrs;
}

std::vector<std::uint8_t> make_header(const las::RecordEncoder& encoder, const Vlrs& vlrs, const Statistics& statistics,
                                      std::uint64_t points, unsigned encoding) {
  const bool legacy = !las::point_layout(encoder.point_format()).extended;
  std::vector<std::uint8_t> h(legacy ? 227 : 375);
  std::memcpy(h.data(), "LASF", 4);
  store(&h[6], static_cast<std::uint16_t>(encoding));
  h[24] = 1;
  h[25] = legacy ? 2 : 4;
  store_text(&h[26], 32, "Bole");
  store_text(&h[58], 32, "Bole");
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  const std::chrono::year_month_day date{today};
  store(&h[90], static_cast<std::uint16_t>((today - std::chrono::sys_days{date.year() / 1 / 1}).count() + 1));
  store(&h[92], static_cast<std::uint16_t>(static_cast<int>(date.year())));
  store(&h[94], static_cast<std::uint16_t>(h.size()));
  store(&h[96], static_cast<std::uint32_t>(h.size() + vlrs.bytes.size()));
  store(&h[100], vlrs.count);
  h[104] = static_cast<std::uint8_t>(encoder.point_format());
  store(&h[105], static_cast<std::uint16_t>(encoder.record_length()));
  if (legacy) {
    store(&h[107], static_cast<std::uint32_t>(points));
    for (std::size_t i = 0; i < 5; ++i) store(&h[111 + 4 * i], static_cast<std::uint32_t>(statistics.by_return[i]));
  } else {
    store(&h[247], points);
    for (std::size_t i = 0; i < 15; ++i) store(&h[255 + 8 * i], statistics.by_return[i]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double scale = encoder.grid().scale[axis], offset = encoder.grid().offset[axis];
    store(&h[131 + 8 * k], scale);
    store(&h[155 + 8 * k], offset);
    if (points == 0) continue;
    store(&h[179 + 16 * k], statistics.max[k] * scale + offset),
        store(&h[187 + 16 * k], statistics.min[k] * scale + offset);
  }
  return h;
}

void write_bytes(AtomicFile& file, Bytes bytes) {
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

void write_las(const std::filesystem::path& path, const PointCloud& cloud, const LasWriteOptions& options,
               const Run& run, Report* report) {
  const bool legacy = options.version == "1.2";
  if (!legacy && options.version != "1.4") throw bad_input("LAS version '" + options.version + "'", "1.2 or 1.4");
  if (legacy && cloud.size() > std::numeric_limits<std::uint32_t>::max())
    throw bad_input(fmt::format("{} points", cloud.size()), "at most 4294967295 for LAS 1.2", "Write LAS 1.4");
  std::vector<std::string> warnings;
  const auto kind = cloud.facts.find(std::string(las::gps_time_fact));
  const bool gps_time = kind != cloud.facts.end();
  las::RecordEncoder encoder(cloud, las::choose_grid(cloud, options.scale_m), legacy, options.extra_bytes, gps_time);
  if (cloud.has(arrays::time) && !gps_time && !options.extra_bytes)
    warnings.emplace_back("the times are not GPS time, which is what a LAS field holds: they were not written");
  const Vlrs vlrs = make_vlrs(cloud, encoder, legacy, warnings);
  // The bit for WKT is required of formats 6 and up, also without a CRS.
  const unsigned encoding =
      (legacy ? 0 : las::wkt_bit) | (gps_time && kind->second == las::gps_standard ? las::standard_time_bit : 0);

  AtomicFile file(path);
  Statistics statistics;
  write_bytes(file, make_header(encoder, vlrs, statistics, 0, encoding));
  write_bytes(file, vlrs.bytes);
  constexpr std::size_t block = 1 << 14;
  std::vector<std::uint8_t> records;
  for (std::size_t begin = 0; begin < cloud.size(); begin += block) {
    run.check_cancel();
    const std::size_t count = std::min(block, cloud.size() - begin);
    records.assign(count * encoder.record_length(), 0);
    encoder.encode(begin, count, records.data());
    for (std::size_t i = 0; i < count; ++i) statistics.add(encoder, &records[i * encoder.record_length()]);
    write_bytes(file, records);
    if (!file.stream()) break;  // commit() reports a full disk
    leave_memory(cloud, begin, count);
    run.report(static_cast<double>(begin + count) / static_cast<double>(cloud.size()), "writing points");
  }
  file.stream().seekp(0);
  write_bytes(file, make_header(encoder, vlrs, statistics, cloud.size(), encoding));
  file.commit();
  for (auto& text : encoder.warnings()) warnings.push_back(std::move(text));
  if (report != nullptr)
    for (auto& text : warnings) report->warn(std::move(text));
}

}  // namespace bole::io
