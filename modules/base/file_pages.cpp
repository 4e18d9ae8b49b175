#include "base/file_pages.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <utility>

namespace bole {
inline namespace base {
namespace {

namespace fs = std::filesystem;

// Begin and end of all file pages that there are.
struct KnownPages {
  std::mutex mutex;
  std::map<const std::byte*, const std::byte*, std::less<>> end_of;

  // The last that begins at or before an address, else the first of all.
  auto first_at(const std::byte* address) {
    auto it = end_of.upper_bound(address);
    return it == end_of.begin() ? it : std::prev(it);
  }
};

KnownPages& known_pages() {
  static auto* known = new KnownPages;  // NOLINT: outlives whatever is freed at exit
  return *known;
}

std::size_t page_bytes() {
  static const auto size = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return size;
}

// The whole pages within a range.
std::pair<std::byte*, std::size_t> whole_pages(const void* begin, std::size_t bytes) {
  const std::size_t page = page_bytes();
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) / page * page, last = (address + bytes) / page * page;
  return {reinterpret_cast<std::byte*>(first), last > first ? last - first : 0};  // NOLINT: pages have addresses only
}

class ScratchFile {
 public:
  // A file of that size whose room on the disk is taken: a write to it cannot find the disk full later.
  ScratchFile(const fs::path& folder, std::size_t bytes)
      : descriptor_(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600)) {
    if (descriptor_ >= 0 && ::fallocate(descriptor_, 0, 0, static_cast<off_t>(bytes)) != 0) close();
  }
  ~ScratchFile() { close(); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  bool write(const std::byte* data, std::size_t bytes) const {
    for (std::size_t done = 0; done < bytes;) {
      const auto written = ::pwrite(descriptor_, data + done, bytes - done, static_cast<off_t>(done));
      if (written <= 0) return false;
      done += static_cast<std::size_t>(written);
    }
    return true;
  }

  bool map_over(std::byte* data, std::size_t bytes) const {
    return ::mmap(data, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, descriptor_, 0) != MAP_FAILED;
  }

 private:
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }
  int descriptor_;
};

bool is_in_memory(const fs::path& folder) {
  struct statfs status {};
  return ::statfs(folder.c_str(), &status) == 0 && (status.f_type == TMPFS_MAGIC || status.f_type == RAMFS_MAGIC);
}

}  // namespace

void know_file_pages(const void* begin, std::size_t bytes) {
  if (bytes == 0) return;
  const auto* const first = static_cast<const std::byte*>(begin);
  const std::lock_guard lock(known_pages().mutex);
  known_pages().end_of[first] = first + bytes;
}

void forget_file_pages(const void* begin) {
  const std::lock_guard lock(known_pages().mutex);
  known_pages().end_of.erase(static_cast<const std::byte*>(begin));
}

FilePages::FilePages(const void* begin, std::size_t bytes)
    : begin_(static_cast<const std::byte*>(begin)), bytes_(bytes) {
  know_file_pages(begin_, bytes_);
}

FilePages::~FilePages() {
  if (bytes_ > 0) forget_file_pages(begin_);
}

FilePages::FilePages(FilePages&& other) noexcept
    : begin_(std::exchange(other.begin_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}

FilePages& FilePages::operator=(FilePages&& other) noexcept {
  std::swap(begin_, other.begin_), std::swap(bytes_, other.bytes_);
  return *this;
}

FilePages lay_on_file(void* data, std::size_t bytes, Content content, const std::vector<fs::path>& folders) {
  const auto [begin, size] = whole_pages(data, bytes);
  if (bytes < min_file_bytes) return {};
  for (const auto& folder : folders) {
    const ScratchFile file(folder, size);
    if (!file.is_open() || (content == Content::keep && !file.write(begin, size))) continue;
    if (file.map_over(begin, size)) return {begin, size};
  }
  return {};
}

std::vector<fs::path> scratch_folders(const Run& run) {
  std::vector<fs::path> folders;
  const auto add = [&](const fs::path& folder) {
    std::error_code ignored;
    if (!folder.empty() && fs::is_directory(folder, ignored) && !is_in_memory(folder)) folders.push_back(folder);
  };
  add(run.scratch_dir);
  std::error_code ignored;
  add(fs::temp_directory_path(ignored));
  add("/var/tmp");
  add(run.output_dir);
  return folders;
}

bool lies_on_file(const void* begin, std::size_t bytes) {
  const auto [first, size] = whole_pages(begin, bytes);
  auto& known = known_pages();
  const std::lock_guard lock(known.mutex);
  const auto it = known.first_at(first);
  return size > 0 && it != known.end_of.end() && it->first <= first && it->second >= first + size;
}

void leave_memory(const void* begin, std::size_t bytes) {
  if (bytes == 0) return;
  auto& known = known_pages();
  const auto* const first = static_cast<const std::byte*>(begin);
  const auto* const last = first + bytes;
  const std::lock_guard lock(known.mutex);
  for (auto it = known.first_at(first); it != known.end_of.end() && it->first < last; ++it) {
    const auto* const from = std::max(first, it->first);
    const auto* const to = std::min(last, it->second);
    if (from >= to) continue;
    // The pages at the ends of a file mapping are its own though the file fills them in part only.
    const auto [pages, size] = whole_pages(from, static_cast<std::size_t>(to - from));
    if (size > 0) ::madvise(pages, size, MADV_DONTNEED);
  }
}

}  // namespace base
}  // namespace bole
