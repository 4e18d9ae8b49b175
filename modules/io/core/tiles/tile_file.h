// The file of a tile: header and records of the source, points of its own.
#pragma once

#include <array>
#include <filesystem>

#include "base/run.h"
#include "cloud/facts.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_info.h"
#include "io/core/tiles/tile_parts.h"

namespace bole::io::las {

// What the header says of the points.
struct TileStatistics {
  std::uint64_t points = 0;
  IntegerBox box;
  std::array<std::uint64_t, 15> by_return{};

  void add(const std::uint8_t* record, bool extended);
};

// Writes the records in `parts`, of the layout of the source, as a file of the same version and point format, with its
// coordinate system and extra bytes, and with `facts`: LAZ, or LAS for the formats that LAZ does not hold. The file
// appears under its name only when it is whole. Throws Error{failed}, Error{cancelled}.
void write_tile_file(const std::filesystem::path& path, const TileParts& parts, Bytes source, const LasInfo& info,
                     const TileStatistics& statistics, const Facts& facts, const Run& run);

}  // namespace bole::io::las
