// The content of a compressed file in a scratch file of its own.
#pragma once

#include <filesystem>
#include <string>

#include "base/run.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

bool is_zstd(Bytes file);

// The scratch file goes away with the object; who has opened it keeps its content.
class ScratchCopy {
 public:
  // Throws Error{bad_input} where the file is cut off or damaged from the start, Error{failed} where the disk is full.
  ScratchCopy(Bytes zstd_file, const std::string& name, const Run& run);
  ~ScratchCopy();
  ScratchCopy(const ScratchCopy&) = delete;
  ScratchCopy& operator=(const ScratchCopy&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bole::io
