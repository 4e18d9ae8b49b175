// Header and variable length records of a file that is written.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/core/las/las_bytes.h"
#include "io/core/las/las_records.h"

namespace bole::io::las {

// What the header says of the points.
struct RecordStatistics {
  using Steps = std::array<std::int32_t, 3>;
  static constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min(),
                                highest = std::numeric_limits<std::int32_t>::max();
  std::uint64_t points = 0;
  Steps min{highest, highest, highest}, max{lowest, lowest, lowest};
  std::array<std::uint64_t, 15> by_return{};
  double min_time = std::numeric_limits<double>::infinity();  // where the records hold GPS times
  double max_time = -std::numeric_limits<double>::infinity();

  void add(const RecordForm& form, const std::uint8_t* records, std::size_t count);
  void add(const RecordStatistics& other);
};

class VlrList {
 public:
  void add(std::string_view user, int id, Bytes data, std::string_view description);
  void append(const VlrList& others) {
    bytes_.insert(bytes_.end(), others.bytes_.begin(), others.bytes_.end());
    count_ += others.count_;
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t count_ = 0;
};

// Header and data of an extended record.
std::vector<std::uint8_t> extended_vlr(std::string_view user, int id, Bytes data, std::string_view description);

// Coordinate system, extra bytes and facts of the cloud.
void add_cloud_vlrs(const PointCloud& cloud, const RecordEncoder& encoder, VlrList& vlrs,
                    std::vector<std::string>& warnings);

struct HeaderParts {
  bool compressed = false;
  unsigned encoding = 0;         // global encoding: standard_time_bit, wkt_bit
  std::uint64_t first_evlr = 0;  // where the extended records begin
  std::uint32_t evlrs = 0;
};

// LAS 1.2 for the formats 0 to 3, else 1.4. The points begin behind header and records.
std::vector<std::uint8_t> make_header(const RecordForm& form, const VlrList& vlrs, const RecordStatistics& statistics,
                                      const HeaderParts& parts);

}  // namespace bole::io::las
