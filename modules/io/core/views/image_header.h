// What the first bytes of an image file say, before anything is decoded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "io/core/bytes/mapped_file.h"

namespace bole::io {

enum class ImageKind { png, jpeg, pgm };

struct ImageHeader {
  ImageKind kind = ImageKind::png;
  int width = 0, height = 0;
  int channels = 0;      // a palette counts as three
  int bits = 0;          // per channel
  std::size_t data = 0;  // PGM: where the values begin
};

// Nothing where the bytes are none of PNG, JPEG and binary PGM (P5), where their header is cut off, or where it names a
// size that the file cannot hold.
std::optional<ImageHeader> image_header(Bytes file);

// The same of a file. Throws Error{bad_input} that names it.
ImageHeader read_image_header(const std::filesystem::path& path);

// Whether a JPEG has its end. Decoders fill what is cut off with grey and say nothing.
bool is_whole_jpeg(Bytes file);

}  // namespace bole::io
