#include "vtkbridge/file_keys.h"

#include <spdlog/spdlog.h>
#include <sys/stat.h>
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
constexpr std::uintmax_t always_read_bytes = std::uintmax_t{64} << 20;  // some hundredths of a second
constexpr int memo_format = 2;

// What the file system says about a file; empty where it cannot.
std::string stamp_of(const fs::path& path) {
  struct stat s {};
  if (::stat(path.c_str(), &s) != 0) return {};
  const auto ns = [](const timespec& t) { return std::to_string(t.tv_sec) + "." + std::to_string(t.tv_nsec); };
  return std::to_string(s.st_size) + " " + std::to_string(s.st_ino) + " " + ns(s.st_mtim) + " " + ns(s.st_ctim);
}

// The key of blocks from the beginning to the end of a file.
std::string sample_of(const fs::path& path, std::uintmax_t size) {
  constexpr std::uintmax_t blocks = 32;
  std::vector<char> block(std::size_t{64} << 10);
  std::ifstream in(path, std::ios::binary);
  ContentHash hash;
  hash.add_value(static_cast<std::uint64_t>(size));
  const std::uintmax_t last = size > block.size() ? size - block.size() : 0;
  for (std::uintmax_t i = 0; i < blocks && in; ++i) {
    in.seekg(static_cast<std::streamoff>(last / (blocks - 1) * i + (i + 1 == blocks ? last % (blocks - 1) : 0)));
    in.read(block.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(block.size(), size)));
    hash.add_bytes(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(in.gcount()))));
  }
  return hash.hex();
}
}  // namespace

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
    if (memo.value("format", 0) != memo_format) return;
    for (const auto& [path, entry] : memo.at("files").items())
      known_[path] = {entry.at("stamp").get<std::string>(), entry.at("sample").get<std::string>(),
                      entry.at("key").get<std::string>()};
  } catch (const nlohmann::json::exception&) {
    known_.clear();  // a damaged memo costs a reading, nothing else
  }
}

void FileKeys::save() {
  if (!changed_) return;
  changed_ = false;
  nlohmann::json files = nlohmann::json::object();
  for (const auto& [path, known] : known_)
    files[path] = {{"stamp", known.stamp}, {"sample", known.sample}, {"key", known.key}};
  const nlohmann::json j{{"format", memo_format}, {"files", std::move(files)}};
  try {
    write_text_file(memo_file_, j.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } catch (const Error& e) {
    spdlog::warn("what is known of the input files is not kept: {}", e.what());
  }
}

namespace {

// The measurements of an inertial unit that a reader of scans finds by itself beside its file or folder.
std::vector<fs::path> inertial_beside(const fs::path& path) {
  std::vector<fs::path> files;
  for (const std::string& name : {path.stem().string() + "_imu.csv", std::string("imu.csv")})
    if (const auto file = path.parent_path() / name; file != path && fs::is_regular_file(file)) files.push_back(file);
  return files;
}

// The files that a path stands for, sorted: the file itself; of a folder all that are in it and the times beside it;
// and what an inertial unit measured.
std::vector<fs::path> files_of(const fs::path& path) {
  std::vector<fs::path> files = inertial_beside(path);
  if (fs::is_regular_file(path)) {
    files.insert(files.begin(), path);
    return files;
  }
  if (!fs::is_directory(path)) return files;
  // What a survey keeps to be run again faster is no result of it, and larger than all of them.
  const bool is_survey = fs::is_regular_file(path / "summary.json");
  for (auto entry = fs::recursive_directory_iterator(path); entry != fs::recursive_directory_iterator(); ++entry) {
    if (is_survey && entry.depth() == 0 && entry->path().filename() == "cache") entry.disable_recursion_pending();
    if (entry->is_regular_file()) files.push_back(entry->path());
  }
  for (const char* beside : {"times.txt", "timestamps.txt"})
    if (const auto file = path.parent_path() / beside; fs::is_regular_file(file)) files.push_back(file);
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::string change_stamp(const fs::path& path) {
  try {
    std::string stamp;
    for (const auto& file : files_of(whole_path(path))) stamp += file.string() + '\n' + stamp_of(file) + '\n';
    return stamp;
  } catch (const fs::filesystem_error&) {
    return "unreadable";
  }
}

std::string FileKeys::file_key(const fs::path& path, const Run& run, bool in_large_folder) {
  const std::string name = fs::absolute(path).lexically_normal().string();
  const auto size = fs::file_size(path);
  Known now{stamp_of(path), {}, {}};
  const bool is_large = size > always_read_bytes, keeps = is_large || in_large_folder;
  if (keeps) {
    if (is_large) now.sample = sample_of(path, size);
    const auto it = known_.find(name);
    if (it != known_.end() && it->second.stamp == now.stamp && it->second.sample == now.sample) return it->second.key;
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) return "unreadable";
  ContentHash hash;
  std::vector<char> buffer(std::size_t{1} << 20);
  std::uintmax_t done = 0;
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    run.check_cancel();
    hash.add_bytes(std::as_bytes(std::span(buffer.data(), static_cast<std::size_t>(in.gcount()))));
    done += static_cast<std::uintmax_t>(in.gcount());
    if (size > large_file_bytes)
      run.report(static_cast<double>(done) / static_cast<double>(size),
                 "reading " + path.filename().string() + " to see whether its result is known");
  }
  now.key = hash.hex();
  if (keeps) {
    known_[name] = now;
    changed_ = true;
  }
  return now.key;
}

std::string FileKeys::key(const fs::path& path, const Run& run) {
  try {
    if (fs::is_regular_file(path)) {
      const auto files = files_of(whole_path(path));
      if (files.size() == 1) return file_key(path, run);
      ContentHash all;
      for (const auto& file : files) all.add_text(file_key(file, run));
      return all.hex();
    }
    if (!fs::is_directory(path)) return "absent";
    ContentHash hash;
    const fs::path folder = whole_path(path);
    const auto files = files_of(folder);
    std::uintmax_t bytes = 0;
    for (const auto& file : files) bytes += fs::file_size(file);
    for (const auto& file : files) {
      run.check_cancel();
      hash.add_text(file.lexically_relative(folder).string());
      hash.add_text(file_key(file, run, bytes > always_read_bytes));
    }
    return hash.hex();
  } catch (const fs::filesystem_error&) {
    return "unreadable";
  }
}

fs::path whole_path(const fs::path& path) {
  if (path.empty()) return path;
  const auto whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace bole::vtkbridge
