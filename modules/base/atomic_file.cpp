#include "base/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <string>

#include "base/error.h"

namespace bole {
inline namespace base {
namespace {

namespace fs = std::filesystem;

// The extension stays: some writers look at it. The number keeps threads apart that write the same file.
fs::path draft_of(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return path.parent_path() / (path.stem().string() + ".partial-" + std::to_string(::getpid()) + "-" +
                               std::to_string(counter++) + path.extension().string());
}

void make_folder_of(const fs::path& path) {
  std::error_code ignored;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), ignored);
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

void put_in_place(const fs::path& draft, const fs::path& path) {
  std::error_code error;
  fs::rename(draft, path, error);
  if (!error) return;
  remove_quietly(draft);
  throw failure("cannot put '" + path.string() + "' in place: " + error.message());
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path& temporary)>& write) {
  const auto draft = draft_of(path);
  make_folder_of(path);
  try {
    write(draft);
  } catch (...) {
    remove_quietly(draft);
    throw;
  }
  put_in_place(draft, path);
}

AtomicFile::AtomicFile(const fs::path& path) : path_(path), temporary_(draft_of(path)) {
  make_folder_of(path);
  stream_.open(temporary_, std::ios::binary);
  if (!stream_) throw failure("cannot write '" + path.string() + "'", "a folder that may be written to");
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  remove_quietly(temporary_);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw failure("cannot write '" + path_.string() + "'", "space on the disk");
  committed_ = true;
  put_in_place(temporary_, path_);
}

void write_text_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  file.commit();
}

}  // namespace base
}  // namespace bole
