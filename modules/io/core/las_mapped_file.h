// A file seen as bytes, without copying it.
#pragma once

#include <filesystem>

#include "io/core/las_bytes.h"

namespace bole::las {

// Throws Error{bad_input} when the file cannot be opened. A file that another program shortens while it is mapped cannot be
// read safely; that is the one case this does not guard against.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  Bytes bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace bole::las
