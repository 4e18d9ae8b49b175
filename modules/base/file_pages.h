// Memory whose pages lie in a file: the system may take them away whenever it wants the room and brings them back when
// they are touched. What lets a cloud be larger than memory while everything else still sees plain vectors.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "base/run.h"

namespace bole {
inline namespace base {

// A stretch of memory that is known to be pages of a file, for as long as this object lives. It must be gone before the
// memory is: declare it behind the owner.
class FilePages {
 public:
  FilePages() = default;
  // Pages that a file was mapped to: `bytes` at `begin`.
  FilePages(const void* begin, std::size_t bytes);
  ~FilePages();
  FilePages(FilePages&& other) noexcept;
  FilePages& operator=(FilePages&& other) noexcept;

  explicit operator bool() const { return bytes_ > 0; }

 private:
  const std::byte* begin_ = nullptr;
  std::size_t bytes_ = 0;
};

// The same for an owner that cannot hold such an object: from the first call to the second.
void know_file_pages(const void* begin, std::size_t bytes);
void forget_file_pages(const void* begin);

enum class Content { keep, undefined };

// Blocks of at least this size have pages of their own and go back to the system when they are freed (the C library's
// largest threshold for that, mallopt(3)); smaller ones may share pages with others.
inline constexpr std::size_t min_file_bytes = std::size_t{33} << 20;

// Puts a scratch file without a name under the memory at `data`, the whole of a block from the heap, but for the ends
// that are no whole pages. Addresses stay as they are, and with Content::keep values too. The memory is freed as
// always, which frees the file. Nothing may write to it meanwhile. Gives nothing, and leaves the memory alone, when the
// block is smaller than min_file_bytes or none of the folders has the room.
FilePages lay_on_file(void* data, std::size_t bytes, Content content,
                      const std::vector<std::filesystem::path>& folders);

// Where scratch files go, the best place first: Run::scratch_dir, else the system's temporary folders and the output
// folder. Folders that are kept in memory are left out.
std::vector<std::filesystem::path> scratch_folders(const Run& run = {});

// Whether all of it, but for the ends that are no whole pages, is known to be file pages.
bool lies_on_file(const void* begin, std::size_t bytes);

// Tells the system that these bytes are not needed soon. Those of file pages leave memory until they are touched again;
// other memory stays as it is, so that any range may be given.
void leave_memory(const void* begin, std::size_t bytes);

}  // namespace base
}  // namespace bole
