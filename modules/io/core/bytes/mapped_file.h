// A file seen as bytes, without copying it: what every reader of whole files works on, and what tests and fuzzers
// replace by a buffer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace bole::io {

using Bytes = std::span<const std::uint8_t>;

class MappedFile {
 public:
  // Throws Error{bad_input} when the file cannot be opened or is a folder. A file that another program shortens while
  // it is mapped cannot be read safely; that is the one case this does not guard against.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  Bytes bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace bole::io
