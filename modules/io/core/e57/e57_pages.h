// The pages of an E57 file: each ends with a CRC-32C of its data, in big-endian order. Behind them lies a logical file
// without checksums, in which sections and packets are contiguous (ASTM E2807, section 6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/core/bytes/mapped_file.h"

namespace bole::io::e57 {

std::uint32_t crc32c(Bytes bytes);

// The fields of the first 48 bytes.
struct FileHeader {
  std::uint64_t length = 0;      // of the file, as declared
  std::uint64_t xml_offset = 0;  // of the description, physical
  std::uint64_t xml_length = 0;  // logical
  std::uint64_t page_size = 1024;
};

bool looks_like_e57(Bytes file);

// Throws Error{bad_input} where it is none that can be read.
FileHeader read_header(Bytes file);

class Pages {
 public:
  Pages(Bytes file, std::uint64_t page_size);

  std::uint64_t size() const { return size_; }  // of the logical file
  std::uint64_t logical(std::uint64_t physical) const;
  std::uint64_t data_per_page() const { return page_ - checksum_bytes; }

  // Logical bytes [begin, begin + out.size()); false where they reach beyond the file.
  bool read(std::uint64_t begin, std::span<std::uint8_t> out) const;

  // Whether the checksum of the page that holds a logical byte is right. Each page is looked at once.
  bool sound(std::uint64_t at);
  bool sound(std::uint64_t begin, std::uint64_t size);
  std::size_t damaged() const { return damaged_; }  // pages met so far

 private:
  static constexpr std::uint64_t checksum_bytes = 4;
  enum class State : std::uint8_t { unknown, sound, damaged };
  Bytes file_;
  std::uint64_t page_, size_ = 0;
  std::vector<State> states_;
  std::size_t damaged_ = 0;
};

}  // namespace bole::io::e57
