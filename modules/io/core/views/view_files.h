// The image files of views: colour, depth and masks, read and written.
#pragma once

#include <array>
#include <filesystem>
#include <limits>

#include "camera/image.h"
#include "io/core/views/image_header.h"

namespace bole::io {

// How a depth image counts. 0 and 65535 stand for no depth.
struct DepthCoding {
  double units_per_metre = 1000;
  double max_depth = std::numeric_limits<double>::infinity();  // metres; farther values count as none
  std::array<double, 3> bias{};                                // added to a depth z: b0 + b1 z + b2 z^2, metres
  bool little_endian_pgm = false;  // PGM files of 16 bits: the lower byte first (the standard says the higher)
};

// The pixels as stored, red first; grey becomes three equal channels, 16 bits become 8. What a camera writes about its
// attitude (EXIF) is ignored, because a calibration is of the pixels as stored. An alpha channel becomes the mask (255
// where it is half or more), and the colours are laid over white, as NeRF's data are meant; without one the mask is
// empty. All of them throw Error{bad_input} that names the file.
void read_color(const std::filesystem::path& path, ColorImage& color, MaskImage& mask);

// Metres. One channel of 16 bits.
void read_depth(const std::filesystem::path& path, const DepthCoding& coding, DepthImage& depth);

// 255 where the file is not black: any number of channels.
void read_mask(const std::filesystem::path& path, MaskImage& mask);

// Whether the values of a 16-bit PGM vary less from pixel to pixel when the lower byte comes first.
bool seems_little_endian_pgm(Bytes file);

// By the ending: .png, .jpg or .jpeg. Throw Error{failed}.
void write_color(const std::filesystem::path& path, const ColorImage& color);
// PNG with 16 bits; depth that does not fit becomes 0.
void write_depth(const std::filesystem::path& path, const DepthImage& depth, double units_per_metre = 1000);
void write_mask(const std::filesystem::path& path, const MaskImage& mask);

}  // namespace bole::io
