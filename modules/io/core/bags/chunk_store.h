// Blocks of a bag that may be compressed, decompressed when they are needed.
#pragma once

#include <cstdint>
#include <list>
#include <string>
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

// A message of rosbag2, decompressed into `room` where the recorder compressed each by itself. Throws
// Error{bad_input} where it is damaged.
Bytes whole_message(Bytes stored, const std::string& name, std::vector<std::uint8_t>& room);

class ChunkStore {
 public:
  std::uint32_t add(Compression compression, Bytes stored, std::uint64_t size);

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
  void make_way() const;

  std::vector<Chunk> chunks_;
  mutable std::list<Kept> kept_;  // last used first
};

}  // namespace bole::io
