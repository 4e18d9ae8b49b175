// Files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string_view>

namespace bole {
inline namespace base {

// Lets `write` make the file under a temporary name in the same folder (created when missing, same extension) and
// renames it to `path` when it returns; removes it when it throws. Throws Error{failed} when that cannot be done.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

// Writes go to a temporary file beside `path`; commit() puts it in place. Without a commit it is removed.
class AtomicFile {
 public:
  // Creates missing folders. Throws Error{failed} when the file cannot be created.
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ofstream& stream() { return stream_; }
  // Throws Error{failed} when anything could not be written.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace base
}  // namespace bole
