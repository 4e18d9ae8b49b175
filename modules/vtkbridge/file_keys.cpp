#include "vtkbridge/file_keys.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/atomic_file.h"
#include "base/content_hash.h"
#include "base/error.h"

namespace bole::vtkbridge {
namespace fs = std::filesystem;
namespace {
constexpr std::uintmax_t large_file_bytes = std::uintmax_t{256} << 20;  // reading it takes long enough to tell about it
}

std::int64_t change_time_ns(const fs::path& path) {
  std::error_code ignored;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(fs::last_write_time(path, ignored).time_since_epoch())
      .count();
}

FileKeys::FileKeys(fs::path memo_file) : memo_file_(std::move(memo_file)) {
  std::ifstream in(memo_file_);
  if (!in) return;
  try {
    const auto memo = nlohmann::json::parse(in);  // outlives items()
    for (const auto& [path, entry] : memo.items())
      known_[path] = {entry.at("size").get<std::uintmax_t>(), entry.at("changed_ns").get<std::int64_t>(),
                      entry.at("key").get<std::string>()};
  } catch (const nlohmann::json::exception&) {
    known_.clear();  // a damaged memo costs a reading, nothing else
  }
}

void FileKeys::save() {
  if (!changed_) return;
  nlohmann::json j = nlohmann::json::object();
  for (const auto& [path, known] : known_)
    j[path] = {{"size", known.size}, {"changed_ns", known.changed_ns}, {"key", known.key}};
  write_text_file(memo_file_, j.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  changed_ = false;
}

namespace {

// Without a slash at its end.
fs::path whole_path(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// The files that a path stands for, sorted: the file itself; of a folder all that are in it and the times beside it.
std::vector<fs::path> files_of(const fs::path& path) {
  if (fs::is_regular_file(path)) return {path};
  std::vector<fs::path> files;
  if (!fs::is_directory(path)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file()) files.push_back(entry.path());
  for (const char* beside : {"times.txt", "timestamps.txt"})
    if (const auto file = path.parent_path() / beside; fs::is_regular_file(file)) files.push_back(file);
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::string change_stamp(const fs::path& path) {
  try {
    std::string stamp;
    for (const auto& file : files_of(whole_path(path)))
      stamp += file.string() + '\n' + std::to_string(fs::file_size(file)) + ' ' + std::to_string(change_time_ns(file)) +
               '\n';
    return stamp;
  } catch (const fs::filesystem_error&) {
    return "unreadable";
  }
}

std::string FileKeys::file_key(const fs::path& path, const Run& run) {
  const std::string name = fs::absolute(path).lexically_normal().string();
  const Known now{fs::file_size(path), change_time_ns(path), {}};
  if (const auto it = known_.find(name);
      it != known_.end() && it->second.size == now.size && it->second.changed_ns == now.changed_ns)
    return it->second.key;
  std::ifstream in(path, std::ios::binary);
  if (!in) return "unreadable";
  ContentHash hash;
  std::vector<char> buffer(std::size_t{1} << 20);
  std::uintmax_t done = 0;
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    run.check_cancel();
    hash.add_bytes(std::as_bytes(std::span(buffer.data(), static_cast<std::size_t>(in.gcount()))));
    done += static_cast<std::uintmax_t>(in.gcount());
    if (now.size > large_file_bytes)
      run.report(static_cast<double>(done) / static_cast<double>(now.size),
                 "reading " + path.filename().string() + " to see whether its result is known");
  }
  known_[name] = {now.size, now.changed_ns, hash.hex()};
  changed_ = true;
  return known_[name].key;
}

std::string FileKeys::key(const fs::path& path, const Run& run) {
  try {
    if (fs::is_regular_file(path)) return file_key(path, run);
    if (!fs::is_directory(path)) return "absent";
    ContentHash hash;
    const fs::path folder = whole_path(path);
    for (const auto& file : files_of(folder)) {
      run.check_cancel();
      hash.add_text(file.lexically_relative(folder).string());
      hash.add_text(file_key(file, run));
    }
    return hash.hex();
  } catch (const fs::filesystem_error&) {
    return "unreadable";
  }
}

}  // namespace bole::vtkbridge
