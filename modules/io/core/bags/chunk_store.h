// Blocks of a bag that may be compressed, decompressed when they are needed.
#pragma once

#include <cstdint>
#include <list>
#include <string_view>
#include <vector>

#include "io/core/bytes/mapped_file.h"

namespace bole::io {

enum class Compression { none, bz2, lz4, zstd, unknown };

// "", "none", "bz2", "lz4", "zstd"
Compression compression_named(std::string_view name);

struct Decompressed {
  std::vector<std::uint8_t> bytes;
  bool whole = false;  // the stream ended as it should
};

// At most `max_bytes`. Memory grows with what the stream really holds, never by a size in a header. A damaged stream
// gives what comes before the damage.
Decompressed decompress(Compression compression, Bytes stored, std::uint64_t max_bytes);

class ChunkStore {
 public:
  std::uint32_t add(Compression compression, Bytes stored, std::uint64_t size);
  std::size_t size() const { return chunks_.size(); }
  bool compressed(std::uint32_t chunk) const { return chunks_[chunk].compression != Compression::none; }

  // The content of a chunk. That of the last few chunks is kept. `whole` is false where it is damaged.
  Bytes bytes(std::uint32_t chunk, bool* whole = nullptr) const;

 private:
  struct Chunk {
    Compression compression;
    Bytes stored;
    std::uint64_t size;
  };
  struct Kept {
    std::uint32_t chunk;
    Decompressed content;
  };
  std::vector<Chunk> chunks_;
  mutable std::list<Kept> kept_;  // last used first
};

}  // namespace bole::io
