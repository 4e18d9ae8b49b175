// Colours of a part of a raster of any kind, as red, green, blue and alpha of 8 bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/run.h"

class GDALDataset;

namespace bole::io {

// Of the raster, and how many pixels it becomes; fewer: each is the mean of those it stands for, or of a palette one of
// them.
struct MapPart {
  int column = 0, row = 0, columns = 0, rows = 0;
  int width = 0, height = 0;
};

// 4 x width x height, rows as in the file. Throws Error{bad_input} where the file cannot be read to its end,
// Error{cancelled}. `name` of the file, for messages.
std::vector<std::uint8_t> map_colors(GDALDataset& set, const MapPart& part, const std::string& name, const Run& run);

}  // namespace bole::io
