// The chunks of a LAZ file, and how one is decoded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

enum class Compressor { none = 0, pointwise = 1, pointwise_chunked = 2, layered_chunked = 3 };

// The record ("laszip encoded", 22204) that says how the points are packed.
struct Packing {
  Compressor compressor = Compressor::pointwise_chunked;
  std::uint32_t chunk_size = 50000;  // points; variable_chunks: as the chunk table says
  std::vector<Item> items;           // their sizes add up to the record length
};
inline constexpr std::uint32_t variable_chunks = ~0U;

// Throws Error{bad_input} when the record is not one, or does not fit the record length.
Packing parse_packing(Bytes record, int record_length);

struct Chunk {
  std::uint64_t begin = 0, end = 0;  // bytes of the file
  std::uint64_t points = 0;
};

// The chunk table, or nothing where the file has none or it is impossible; then chunks must be read in order.
// `data_offset` is where the points begin, `points` is their number.
std::optional<std::vector<Chunk>> read_chunk_table(Bytes file, std::uint64_t data_offset, std::uint64_t points,
                                                   const Packing& packing, int record_length);

// Decodes the points of a chunk in order, as the records that an uncompressed file would have.
class ChunkDecoder {
 public:
  ChunkDecoder(const Packing& packing, int record_length);

  // `bytes` from the chunk's beginning; they may reach further than its end. Returns the number of points in the chunk:
  // `points`, or what a layered chunk says of itself when that is less. 0: not even the first point is there.
  std::uint64_t start(Bytes bytes, std::uint64_t points);

  // Writes up to `count` further records and returns how many are sound; fewer than asked for when the data ended
  // early.
  std::size_t decode(std::uint8_t* records, std::size_t count);

  // Bytes of the chunk, once all its points have been decoded.
  std::size_t length() const;

 private:
  std::uint64_t start_layers(std::size_t at, std::uint64_t points);
  bool overran() const;

  bool layered_;
  std::size_t record_length_;
  std::vector<Item> items_;
  std::vector<std::unique_ptr<PointwiseItem>> pointwise_;
  std::vector<std::unique_ptr<LayeredItem>> layers_;
  ArithmeticDecoder in_;  // of the pointwise items
  Bytes bytes_;
  bool at_first_ = true;
  unsigned channel_ = 0;
  std::size_t layered_length_ = 0;
};

}  // namespace bole::io::laz
