// A file as bytes, mapped into memory. Readers take the bytes, so that tests and fuzz targets can pass a buffer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace bole::io {

using Bytes = std::span<const std::uint8_t>;

class MappedFile {
 public:
  // Throws Error{bad_input} when the file cannot be opened or is a folder. Not safe
  // for a file that another program shortens while it is mapped.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  Bytes bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace bole::io
