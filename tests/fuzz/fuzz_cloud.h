// What the fuzz targets of point clouds share.
#pragma once

#include "fuzz_target.h"
#include "io/core/clouds/cloud_reader.h"

namespace bole::fuzz {

// Reads the bytes with z or y up, by their number.
template <class Reader>
int read_as_cloud(Reader reader, const std::uint8_t* data, std::size_t size) {
  io::CloudReadOptions options;
  options.up = size % 2 == 0 ? io::UpAxis::z : io::UpAxis::y;
  allow_bad_input([&] { reader(io::Bytes(data, size), options, Run{}); });
  return 0;
}

}  // namespace bole::fuzz
