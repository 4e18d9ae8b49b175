// What a tile has on file while the cloud is cut.
#pragma once

#include <filesystem>
#include <vector>

#include "io/core/las/las_info.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::las {

inline constexpr std::size_t points_of_full_chunk = 50'000;

// Whether LAZ holds points of this format. Others stay uncompressed.
bool can_be_packed(int point_format);

// The records of one tile, in the order in which they came. They are compressed as they come, so that cutting takes no
// more room on the disk than the tiles do.
class TileParts {
 public:
  // `path`: the file, which is written over and is removed with this object.
  TileParts(std::filesystem::path path, const LasInfo& info);
  ~TileParts();
  TileParts(const TileParts&) = delete;
  TileParts& operator=(const TileParts&) = delete;

  // Takes full chunks from the front of `records`, or all of them where `all`. Throws Error{failed} where the disk is
  // full.
  void take(std::vector<std::uint8_t>& records, bool all);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t bytes() const { return end_; }
  // Places in the file; none where points stay uncompressed.
  const std::vector<laz::Chunk>& chunks() const { return chunks_; }

 private:
  std::filesystem::path path_;
  std::size_t stride_;
  laz::Packing packing_;
  bool packed_;
  std::uint64_t end_ = 0;
  std::vector<laz::Chunk> chunks_;
};

// The packing of the chunks of TileParts: their sizes vary.
laz::Packing packing_of_parts(const LasInfo& info);

}  // namespace bole::io::las
