// PCD files of the Point Cloud Library, version 0.5 to 0.7: ascii, binary and binary_compressed.
// Source: pointclouds.org, "The PCD file format".
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

bool looks_like_pcd(Bytes file);

// Throws Error{bad_input} that names the header line or field that cannot be used. Warns of points missing at the end.
CloudReading read_pcd(Bytes file, const CloudReadOptions& options, const Run& run);

// Unpacks LZF (the format of liblzf). Throws Error{bad_input} where `packed` does not give `size` bytes.
std::vector<std::uint8_t> lzf_unpack(Bytes packed, std::size_t size);

}  // namespace bole::io
