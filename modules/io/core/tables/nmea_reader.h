// Receiver logs: NMEA 0183 sentences, also mixed with binary messages and other text.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "base/run.h"
#include "cloud/table.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct NmeaCounts {
  std::map<std::string, std::int64_t> sentences;  // good ones, by type without the talker: "GGA"
  std::int64_t good = 0;                          // sentences with the right checksum, of any type
  std::int64_t bad_checksum = 0, without_checksum = 0;
  std::int64_t malformed = 0;                   // right checksum, but a field that cannot be read
  std::int64_t without_fix = 0;                 // GGA of quality 0, RMC that is not valid
  std::int64_t out_of_order = 0;                // epochs that go back in time
  std::int64_t other_bytes = 0;                 // outside of sentences: binary messages, comments
  std::map<std::string, std::int64_t> talkers;  // positions (GGA, RMC) by talker: "GP" GPS alone, "GN" several systems
  std::int64_t talkers_differ = 0;              // epochs whose GGA sentences of two talkers are more than a metre apart
};

struct NmeaLog {
  // One row per epoch with a position: time_s (UTC of day, going on past midnight; seconds since the Unix epoch where
  // an RMC gives the date before the first position), latitude_deg, longitude_deg, height_m (above the ellipsoid where
  // the geoid's height is given, else above sea level), quality (GGA: 1 single, 2 differential, 4 RTK fixed, 5 float, 6
  // estimated; 0 unknown), satellites, hdop, speed_m_s, course_deg, heading_deg (HDT), sd_east_m, sd_north_m,
  // sd_height_m (GST). A value that the log does not give is NaN, or 0 for whole
  // numbers.
  Table track;
  NmeaCounts counts;
};

// Reads GGA, RMC, VTG, GST and HDT of any talker. VTG and HDT belong to the epoch before them. Where two talkers give a
// position for one epoch, that of GN (all systems together) counts, else the first. Bad sentences are counted and
// skipped; no content of a file is an error.
NmeaLog read_nmea(Bytes file, const Run& run = {});

// Whether a file holds NMEA sentences, by its first 64 KiB.
bool looks_like_nmea(Bytes file);

}  // namespace bole::io
