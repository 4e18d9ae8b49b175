#include "io/core/las/las_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "io/core/las/crs_geokeys.h"
#include "io/core/las/las_facts.h"

namespace bole::io::las {

void RecordStatistics::add(const RecordForm& form, const std::uint8_t* records, std::size_t count) {
  points += count;
  for (std::size_t i = 0; i < count; ++i, records += form.record_length) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = load<std::int32_t>(records + 4 * k);
      min[k] = std::min(min[k], v);
      max[k] = std::max(max[k], v);
    }
    const unsigned r = form.return_number(records);
    if (r >= 1 && r <= by_return.size()) ++by_return[r - 1];
    if (!form.holds_time()) continue;
    // A time that is no number leaves both as they are.
    const double time = form.time(records);
    if (time < min_time) min_time = time;
    if (time > max_time) max_time = time;
  }
}

void RecordStatistics::add(const RecordStatistics& other) {
  points += other.points;
  for (std::size_t k = 0; k < 3; ++k) {
    min[k] = std::min(min[k], other.min[k]);
    max[k] = std::max(max[k], other.max[k]);
  }
  for (std::size_t i = 0; i < by_return.size(); ++i) by_return[i] += other.by_return[i];
  min_time = std::min(min_time, other.min_time);
  max_time = std::max(max_time, other.max_time);
}

namespace {

void append_record(std::vector<std::uint8_t>& out, std::string_view user, int id, Bytes data,
                   std::string_view description, bool extended) {
  constexpr std::size_t vlr_head = 54, evlr_head = 60;
  std::vector<std::uint8_t> head(extended ? evlr_head : vlr_head);
  store_text(&head[2], 16, user);
  store(&head[18], static_cast<std::uint16_t>(id));
  if (extended)
    store(&head[20], static_cast<std::uint64_t>(data.size()));
  else
    store(&head[20], static_cast<std::uint16_t>(data.size()));
  store_text(&head[extended ? 28 : 22], 32, description);
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

void add_facts(const Facts& facts, VlrList& vlrs, std::vector<std::string>& warnings) {
  if (facts.empty()) return;
  Facts kept = facts;
  kept.erase("turned");  // the axes of the points are those of this file
  const std::string text = facts_to_json(kept);
  if (text.size() > max_vlr_bytes) {
    warnings.push_back(fmt::format("the facts of the cloud take {} bytes, a LAS record holds {}: they were not written",
                                   text.size(), max_vlr_bytes));
    return;
  }
  vlrs.add(facts_user, facts_record, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
           "facts of the cloud (JSON)");
}

}  // namespace

void VlrList::add(std::string_view user, int id, Bytes data, std::string_view description) {
  append_record(bytes_, user, id, data, description, false);
  ++count_;
}

std::vector<std::uint8_t> extended_vlr(std::string_view user, int id, Bytes data, std::string_view description) {
  std::vector<std::uint8_t> out;
  append_record(out, user, id, data, description, true);
  return out;
}

void add_cloud_vlrs(const PointCloud& cloud, const RecordEncoder& encoder, VlrList& vlrs,
                    std::vector<std::string>& warnings) {
  const bool legacy = !point_layout(encoder.point_format()).extended;
  if (!cloud.crs_wkt.empty()) {
    const int epsg = legacy ? epsg_of_wkt(cloud.crs_wkt) : 0;
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
    std::vector<std::uint8_t> descriptors(encoder.dimensions().size() * extra_descriptor_size);
    for (std::size_t i = 0; i < encoder.dimensions().size(); ++i)
      store_descriptor(encoder.dimensions()[i], &descriptors[i * extra_descriptor_size]);
    vlrs.add("LASF_Spec", 4, descriptors, "extra bytes");
  }
  add_facts(cloud.facts, vlrs, warnings);
}

std::vector<std::uint8_t> make_header(const RecordForm& form, const VlrList& vlrs, const RecordStatistics& statistics,
                                      const HeaderParts& parts) {
  constexpr int compressed_bit = 0x80;
  const bool legacy = !point_layout(form.point_format).extended;
  std::vector<std::uint8_t> h(legacy ? 227 : 375);
  std::memcpy(h.data(), "LASF", 4);
  store(&h[6], static_cast<std::uint16_t>(parts.encoding));
  h[24] = 1;
  h[25] = legacy ? 2 : 4;
  store_text(&h[26], 32, "Bole");
  store_text(&h[58], 32, "Bole");
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  const std::chrono::year_month_day date{today};
  store(&h[90], static_cast<std::uint16_t>((today - std::chrono::sys_days{date.year() / 1 / 1}).count() + 1));
  store(&h[92], static_cast<std::uint16_t>(static_cast<int>(date.year())));
  store(&h[94], static_cast<std::uint16_t>(h.size()));
  store(&h[96], static_cast<std::uint32_t>(h.size() + vlrs.bytes().size()));
  store(&h[100], vlrs.count());
  h[104] = static_cast<std::uint8_t>(form.point_format | (parts.compressed ? compressed_bit : 0));
  store(&h[105], static_cast<std::uint16_t>(form.record_length));
  if (legacy) {
    store(&h[107], static_cast<std::uint32_t>(statistics.points));
    for (std::size_t i = 0; i < 5; ++i) store(&h[111 + 4 * i], static_cast<std::uint32_t>(statistics.by_return[i]));
  } else {
    store(&h[235], parts.first_evlr);
    store(&h[243], parts.evlrs);
    store(&h[247], statistics.points);
    for (std::size_t i = 0; i < 15; ++i) store(&h[255 + 8 * i], statistics.by_return[i]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double scale = form.grid.scale[axis], offset = form.grid.offset[axis];
    store(&h[131 + 8 * k], scale);
    store(&h[155 + 8 * k], offset);
    if (statistics.points == 0) continue;
    store(&h[179 + 16 * k], statistics.max[k] * scale + offset);
    store(&h[187 + 16 * k], statistics.min[k] * scale + offset);
  }
  return h;
}

}  // namespace bole::io::las
