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

// Of a file without the record: none. A damaged record gives warnings.
Facts read_facts(Bytes file, const LasInfo& info, std::vector<std::string>& warnings);

}  // namespace bole::io::las
