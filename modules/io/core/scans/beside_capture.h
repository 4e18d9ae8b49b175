// Small things that readers of recordings share: files that lie beside a recording, and words of their reports.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace bole::io {

inline constexpr std::uintmax_t max_metadata_bytes = 4 << 20;  // of the JSON file of an Ouster sensor

// The text of a small file beside a recording; empty where it cannot be read or is larger than `max_bytes`.
std::string small_file_text(const std::filesystem::path& path, std::uintmax_t max_bytes);

// "1 packet", "2 packets".
std::string plural(std::int64_t count, const std::string& what);

}  // namespace bole::io
