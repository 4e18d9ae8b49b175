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
  // What the compressed file does not hold: empty where it is whole. The share is 0 where the file does not say how
  // much it should hold.
  const std::string& damage() const { return damage_; }
  double lost_share() const { return lost_share_; }

 private:
  void judge(Bytes zstd_file, bool whole, std::uint64_t written);

  std::filesystem::path path_;
  std::string damage_;
  double lost_share_ = 0;
};

}  // namespace bole::io
