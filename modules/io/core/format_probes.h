// What the rows of the table of formats ask a file or its name.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "io/core/formats.h"

namespace bole::io {

std::string lower(std::string_view text);

// The last part of the name, and of COPC both: ".copc.laz". In lower case, with the dot.
std::string ending_of(const std::filesystem::path& path);

bool starts_with(Bytes file, std::string_view text);
bool is_ending(const Candidate& c, std::initializer_list<std::string_view> endings);

bool is_las(Bytes file);
bool is_laz(Bytes file);
bool is_capture(Bytes file);  // pcap or pcapng, of any sensor
bool is_text(Bytes file);     // no control characters in the first 4096 bytes

// A file of ROS 2 that was compressed as a whole: "walk_0.db3.zstd". `ending`: that of the file inside.
bool is_compressed_bag(const Candidate& c, std::string_view ending);

}  // namespace bole::io
