#include "io/core/atomic_file.h"

#include <unistd.h>

#include "base/error.h"

namespace bole {

AtomicFile::AtomicFile(const std::filesystem::path& path)
    : path_(path), temporary_(path.string() + "." + std::to_string(::getpid()) + ".part") {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  stream_.open(temporary_, std::ios::binary);
  if (!stream_) throw failure("cannot write '" + path.string() + "'", "a folder that may be written to");
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw failure("cannot write '" + path_.string() + "'", "space on the disk");
  std::error_code code;
  std::filesystem::rename(temporary_, path_, code);
  if (code) throw failure("cannot put '" + path_.string() + "' in place: " + code.message());
  committed_ = true;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  file.commit();
}

}  // namespace bole
