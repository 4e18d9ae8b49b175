#include "io/core/views/image_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "base/error.h"

namespace bole::io {
namespace {

constexpr std::uint64_t max_pixels = std::uint64_t{1} << 27;  // 134 million

std::uint32_t big_endian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

// The size is believed only where the file could hold it: `packing` is how much smaller than its values it may be.
std::optional<ImageHeader> believed(ImageHeader header, std::uint64_t width, std::uint64_t height, std::size_t file,
                                    std::uint64_t packing) {
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels || width * height > max_pixels)
    return std::nullopt;
  const auto bits = static_cast<std::uint64_t>(header.channels) * static_cast<std::uint64_t>(header.bits);
  if (width * height * bits / 8 / packing > file) return std::nullopt;
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height);
  return header;
}

std::optional<ImageHeader> png_header(Bytes file) {
  constexpr std::array<std::uint8_t, 8> magic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  constexpr std::uint64_t deflate = 1100;  // no stream of deflate packs better than 1032 to 1
  if (file.size() < 33 || !std::equal(magic.begin(), magic.end(), file.begin())) return std::nullopt;
  if (big_endian(file, 8, 4) != 13 || big_endian(file, 12, 4) != 0x49484452) return std::nullopt;  // IHDR
  ImageHeader header{.kind = ImageKind::png, .bits = file[24]};
  switch (file[25]) {
    case 0:
      header.channels = 1;
      break;
    case 3:
      header.bits = 8;
      [[fallthrough]];
    case 2:
      header.channels = 3;
      break;
    case 4:
      header.channels = 2;
      break;
    case 6:
      header.channels = 4;
      break;
    default:
      return std::nullopt;
  }
  if (header.bits != 8 && header.bits != 16 && header.channels != 1) return std::nullopt;
  return believed(header, big_endian(file, 16, 4), big_endian(file, 20, 4), file.size(), deflate);
}

// Calls `use(marker, offset, length)` for the segments of a JPEG up to its pixels, until one returns true. Returns
// where it stopped, or the size of the file.
template <class Use>
std::size_t walk_jpeg(Bytes file, Use&& use) {
  std::size_t at = 2;
  while (at + 4 <= file.size()) {
    if (file[at] != 0xFF) return file.size();
    const auto marker = file[at + 1];
    if (marker == 0xFF) {  // a byte that fills
      ++at;
      continue;
    }
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {  // markers without content
      at += 2;
      continue;
    }
    const std::size_t length = big_endian(file, at + 2, 2);
    if (length < 2) return file.size();
    if (use(marker, at + 4, length - 2)) return at;
    at += 2 + length;
  }
  return file.size();
}

bool is_jpeg(Bytes file) { return file.size() > 4 && file[0] == 0xFF && file[1] == 0xD8 && file[2] == 0xFF; }

std::optional<ImageHeader> jpeg_header(Bytes file) {
  constexpr std::uint64_t packing = 4000;  // of one colour: a block of 8 x 8 in a few bits
  if (!is_jpeg(file)) return std::nullopt;
  std::optional<ImageHeader> found;
  walk_jpeg(file, [&](std::uint8_t marker, std::size_t at, std::size_t length) {
    const bool is_size = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (!is_size) return marker == 0xDA;
    if (length < 6 || at + 6 > file.size()) return true;
    const ImageHeader header{.kind = ImageKind::jpeg, .channels = file[at + 5], .bits = file[at]};
    if (header.channels >= 1 && header.channels <= 4 && header.bits == 8)
      found = believed(header, big_endian(file, at + 3, 2), big_endian(file, at + 1, 2), file.size(), packing);
    return true;
  });
  return found;
}

std::optional<ImageHeader> pgm_header(Bytes file) {
  if (file.size() < 8 || file[0] != 'P' || file[1] != '5') return std::nullopt;
  std::size_t at = 2;
  std::array<std::uint64_t, 3> values{};  // width, height, greatest value
  for (auto& value : values) {
    while (at < file.size() && (std::isspace(file[at]) != 0 || file[at] == '#')) {
      if (file[at] == '#')
        while (at < file.size() && file[at] != '\n') ++at;
      else
        ++at;
    }
    const auto begin = at;
    for (; at < file.size() && std::isdigit(file[at]) != 0 && at - begin < 9; ++at) value = 10 * value + file[at] - '0';
    if (at == begin || at >= file.size()) return std::nullopt;
  }
  if (std::isspace(file[at]) == 0 || values[2] < 1 || values[2] > 65535) return std::nullopt;
  ImageHeader header{.kind = ImageKind::pgm, .channels = 1, .bits = values[2] > 255 ? 16 : 8, .data = at + 1};
  return believed(header, values[0], values[1], file.size() - header.data, 1);
}

}  // namespace

std::optional<ImageHeader> image_header(Bytes file) {
  if (const auto header = png_header(file)) return header;
  if (const auto header = jpeg_header(file)) return header;
  return pgm_header(file);
}

ImageHeader read_image_header(const std::filesystem::path& path) {
  const MappedFile file(path);
  if (file.bytes().empty()) throw bad_input("'" + path.string() + "' is empty", "a PNG, JPEG or PGM image");
  if (const auto header = image_header(file.bytes())) return *header;
  throw bad_input("'" + path.string() + "' is no whole image (" + std::to_string(file.bytes().size()) + " bytes)",
                  "a PNG, JPEG or PGM image");
}

bool is_whole_jpeg(Bytes file) {
  const auto pixels = walk_jpeg(file, [](std::uint8_t marker, std::size_t, std::size_t) { return marker == 0xDA; });
  for (auto at = pixels; at + 1 < file.size(); ++at)
    if (file[at] == 0xFF && file[at + 1] == 0xD9) return true;
  return false;
}

}  // namespace bole::io
