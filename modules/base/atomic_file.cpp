#include "base/atomic_file.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "base/drafts.h"
#include "base/error.h"

namespace bole {
inline namespace base {
namespace {

namespace fs = std::filesystem;

struct OwnDrafts {
  std::mutex mutex;
  std::set<fs::path> all;
};

OwnDrafts& own_drafts() {
  static auto* drafts = new OwnDrafts;  // NOLINT: outlives threads that write when the program ends
  return *drafts;
}

constexpr std::string_view draft_mark = ".partial-";

// The extension stays: some writers look at it. The number keeps threads apart that write the same file.
fs::path draft_of(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return path.parent_path() / (path.stem().string() + std::string(draft_mark) + std::to_string(::getpid()) + "-" +
                               std::to_string(counter++) + path.extension().string());
}

// The process that wrote a draft of this name; nothing where the name is none of draft_of().
std::optional<long> writer_of(const std::string& name) {
  const auto mark = name.rfind(draft_mark);
  if (mark == std::string::npos) return std::nullopt;
  const char* const begin = name.data() + mark + draft_mark.size();
  const char* const end = name.data() + name.size();
  long id = 0;
  unsigned number = 0;
  const auto after_id = std::from_chars(begin, end, id);
  if (after_id.ec != std::errc{} || after_id.ptr == end || *after_id.ptr != '-') return std::nullopt;
  const auto after_number = std::from_chars(after_id.ptr + 1, end, number);
  const bool ends = after_number.ptr == end || *after_number.ptr == '.';
  return after_number.ec == std::errc{} && ends ? std::optional(id) : std::nullopt;
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
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw failure("cannot write '" + path.string() + "': there is a folder of that name", "a name that is free",
                  "Move the folder away");
  throw failure("cannot put '" + path.string() + "' in place: " + error.message());
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path& temporary)>& write) {
  const auto draft = draft_of(path);
  make_folder_of(path);
  remember_draft(draft);
  try {
    write(draft);
  } catch (...) {
    remove_quietly(draft);
    forget_draft(draft);
    throw;
  }
  forget_draft(draft);
  put_in_place(draft, path);
}

AtomicFile::AtomicFile(const fs::path& path) : path_(path), temporary_(draft_of(path)) {
  make_folder_of(path);
  remember_draft(temporary_);
  stream_.open(temporary_, std::ios::binary);
  if (!stream_) {
    forget_draft(temporary_);
    throw failure("cannot write '" + path.string() + "'", "a folder that may be written to");
  }
}

AtomicFile::~AtomicFile() {
  forget_draft(temporary_);
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

void remember_draft(const fs::path& draft) {
  const std::lock_guard lock(own_drafts().mutex);
  own_drafts().all.insert(draft);
}

void forget_draft(const fs::path& draft) {
  const std::lock_guard lock(own_drafts().mutex);
  own_drafts().all.erase(draft);
}

void remove_own_drafts() {
  const std::lock_guard lock(own_drafts().mutex);
  std::error_code ignored;
  for (const auto& draft : own_drafts().all) fs::remove_all(draft, ignored);
}

bool process_runs(long id) { return ::kill(static_cast<pid_t>(id), 0) == 0 || errno != ESRCH; }

std::size_t remove_abandoned_drafts(const fs::path& folder) {
  std::size_t removed = 0;
  std::error_code ignored;
  for (auto it = fs::recursive_directory_iterator(folder, ignored); it != fs::recursive_directory_iterator();
       it.increment(ignored)) {
    if (it->is_symlink(ignored) || !it->is_regular_file(ignored)) continue;
    const auto writer = writer_of(it->path().filename().string());
    if (writer && !process_runs(*writer) && fs::remove(it->path(), ignored)) ++removed;
  }
  return removed;
}

}  // namespace base
}  // namespace bole
