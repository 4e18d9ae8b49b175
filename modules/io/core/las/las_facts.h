// Facts of a cloud in a LAS file: a variable length record of the user "Bole", record 1, whose data are a JSON object
// of texts ({"sensor":"VLP-32C"}). Other programs ignore it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cloud/known_facts.h"
#include "io/core/las/las_info.h"

namespace bole::io::las {

inline constexpr std::string_view facts_user = "Bole";
inline constexpr int facts_record = 1;
inline constexpr std::size_t max_vlr_bytes = 65535;

// What the GPS times of a cloud from a LAS file count from: "week" (seconds of the GPS week) or "standard" (seconds
// since the GPS epoch less 1e9), as bit 0 of the global encoding says. A cloud with times and without this fact has
// those of another clock.
inline constexpr std::string_view gps_time_fact = "las_gps_time", gps_week = "week", gps_standard = "standard";
inline constexpr unsigned standard_time_bit = 1, wkt_bit = 16;  // of the global encoding

// Of a file without the record: none. A damaged record gives warnings.
Facts read_facts(Bytes file, const LasInfo& info, std::vector<std::string>& warnings);

}  // namespace bole::io::las
