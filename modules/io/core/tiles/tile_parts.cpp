#include "io/core/tiles/tile_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "io/core/laz/laz_chunk_encoder.h"

namespace bole::io::las {

namespace fs = std::filesystem;

bool can_be_packed(int point_format) { return point_format <= 3 || (point_format >= 6 && point_format <= 8); }

laz::Packing packing_of_parts(const LasInfo& info) {
  return laz::make_packing(info.point_format, static_cast<std::size_t>(info.record_length), laz::variable_chunks);
}

TileParts::TileParts(fs::path path, const LasInfo& info)
    : path_(std::move(path)),
      stride_(static_cast<std::size_t>(info.record_length)),
      packed_(can_be_packed(info.point_format)) {
  if (packed_) packing_ = packing_of_parts(info);
}

TileParts::~TileParts() {
  std::error_code ignored;
  if (end_ > 0) fs::remove(path_, ignored);
}

void TileParts::take(std::vector<std::uint8_t>& records, bool all) {
  const std::size_t full_bytes = points_of_full_chunk * stride_;
  const std::size_t bytes = all ? records.size() : records.size() / full_bytes * full_bytes;
  if (bytes == 0) return;
  std::ofstream file(path_, std::ios::binary | (end_ > 0 ? std::ios::app : std::ios::trunc));
  const auto put = [&](Bytes part) {
    file.write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
    end_ += part.size();
  };
  for (std::size_t at = 0; at < bytes; at += full_bytes) {
    const Bytes part{records.data() + at, std::min(full_bytes, bytes - at)};
    if (packed_) {
      const auto chunk = laz::encode_chunk(packing_, part.data(), stride_, part.size() / stride_);
      chunks_.push_back({end_, end_ + chunk.size(), part.size() / stride_});
      put(chunk);
    } else {
      put(part);
    }
  }
  file.close();
  if (!file)
    throw failure(fmt::format("'{}' cannot be written: the disk may be full", path_.string()),
                  "room for the tiles, buffers included");
  // What is left begins a vector of its own, so that the memory of the rest is given back.
  records = std::vector<std::uint8_t>(records.begin() + static_cast<std::ptrdiff_t>(bytes), records.end());
}

}  // namespace bole::io::las
