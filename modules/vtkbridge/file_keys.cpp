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

namespace bole {
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
    for (const auto& [path, entry] : nlohmann::json::parse(in).items())
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
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    ContentHash hash;
    for (const auto& file : files) {
      hash.add_text(file.lexically_relative(path).string());
      hash.add_text(file_key(file, run));
    }
    return hash.hex();
  } catch (const fs::filesystem_error&) {
    return "unreadable";
  }
}

}  // namespace bole
