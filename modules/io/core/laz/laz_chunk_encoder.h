// The encoder of LAZ: how records become chunks, and what a file says of them.
#pragma once

#include <cstdint>
#include <vector>

#include "io/core/laz/laz_chunks.h"

namespace bole::io::laz {

// How points of the format (0 to 3: pointwise, 6 to 8: layered) with records of this length are packed. Throws
// Error{bad_input} for other formats and records that are too short. `chunk_size`: points, or variable_chunks.
Packing make_packing(int point_format, std::size_t record_length, std::uint32_t chunk_size);

// The data of the record "laszip encoded" 22204.
std::vector<std::uint8_t> packing_record(const Packing& packing);

// The bytes of a chunk of `count` records, at least one. Chunks are independent of one another.
std::vector<std::uint8_t> encode_chunk(const Packing& packing, const std::uint8_t* records, std::size_t record_length,
                                       std::size_t count);

// The chunk table, which follows the last chunk. Throws Error{bad_input} where a chunk takes 2 GiB or more.
std::vector<std::uint8_t> encode_chunk_table(const Packing& packing, const std::vector<Chunk>& chunks);

}  // namespace bole::io::laz
