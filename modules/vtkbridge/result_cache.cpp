#include "vtkbridge/result_cache.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/atomic_file.h"
#include "base/content_hash.h"
#include "pipeline/report_json.h"

namespace bole::vtkbridge {
namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int entry_format = 2;

ordered_json files_to_json(const std::vector<WrittenFile>& files) {
  auto list = ordered_json::array();
  for (const auto& f : files) list.push_back({{"path", f.path}, {"size", f.size}, {"changed_ns", f.changed_ns}});
  return list;
}

CachedResult parse_entry(const ordered_json& j) {
  CachedResult result;
  result.report = pipeline::report_from_json(j.at("report"));
  for (const auto& [port, stored] : j.at("outputs").items()) result.outputs[port] = stored.dump();
  for (const auto& f : j.at("files"))
    result.files.push_back(
        {f.at("path").get<std::string>(), f.at("size").get<std::uintmax_t>(), f.at("changed_ns").get<std::int64_t>()});
  return result;
}

// The entry of a file, or nothing when it is not one of ours or was changed since.
std::optional<CachedResult> read_entry(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::stringstream text;
  text << in.rdbuf();
  try {
    const auto j = ordered_json::parse(text.str());
    const auto body = j.at("entry").dump();
    if (j.at("format").get<int>() != entry_format ||
        j.at("checksum").get<std::string>() != content_hash(std::as_bytes(std::span(body))))
      return std::nullopt;
    return parse_entry(j.at("entry"));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<WrittenFile> list_files(const fs::path& folder, const fs::path& except) {
  std::vector<WrittenFile> files;
  std::error_code ignored;
  for (auto it = fs::recursive_directory_iterator(folder, ignored); it != fs::recursive_directory_iterator();
       it.increment(ignored)) {
    if (!except.empty() && it->is_directory(ignored) && fs::equivalent(it->path(), except, ignored))
      it.disable_recursion_pending();
    if (it->is_regular_file(ignored))
      files.push_back({it->path().string(), it->file_size(ignored), change_time_ns(it->path())});
  }
  std::ranges::sort(files, {}, &WrittenFile::path);
  return files;
}

std::vector<WrittenFile> changed_files(const std::vector<WrittenFile>& before, const std::vector<WrittenFile>& after) {
  std::vector<WrittenFile> changed;
  for (const auto& file : after) {
    const auto old = std::ranges::find(before, file.path, &WrittenFile::path);
    if (old == before.end() || old->size != file.size || old->changed_ns != file.changed_ns) changed.push_back(file);
  }
  return changed;
}

bool all_there(const std::vector<WrittenFile>& files) {
  return std::ranges::all_of(files, [](const WrittenFile& f) {
    std::error_code ignored;
    return fs::is_regular_file(f.path, ignored) && fs::file_size(f.path, ignored) == f.size &&
           change_time_ns(f.path) == f.changed_ns;
  });
}

ResultCache::ResultCache(fs::path folder) : folder_(std::move(folder)), file_keys_(folder_ / "files.json") {}

fs::path ResultCache::blob_path(const std::string& id) const {
  if (id.size() != 32 || id.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw failure("stored result: '" + id + "' names no array");
  return folder_ / "blobs" / id.substr(0, 2) / id;
}

fs::path ResultCache::result_path(const std::string& key) const { return folder_ / "results" / (key + ".json"); }

std::string ResultCache::file_key(const fs::path& path, const Run& run) {
  const std::lock_guard lock(mutex_);
  std::string key = file_keys_.key(path, run);
  file_keys_.save();
  return key;
}

// Arrays of large clouds take seconds: they go piece by piece, and a cancel is heard between two of them.
class ResultCache::PolledStore : public BlobStore {
 public:
  PolledStore(ResultCache& cache, const Run& run) : cache_(cache), run_(run) {}
  std::string put(std::span<const std::byte> bytes) override { return cache_.put(bytes, run_); }
  std::size_t size(const std::string& id) const override { return cache_.size(id); }
  void get(const std::string& id, std::span<std::byte> into) const override { cache_.get(id, into); }

 private:
  ResultCache& cache_;
  const Run& run_;
};

namespace {

template <class F>
void in_pieces(std::span<const std::byte> bytes, const Run& run, F&& f) {
  constexpr std::size_t piece = std::size_t{16} << 20;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    run.check_cancel();
    f(bytes.subspan(at, std::min(piece, bytes.size() - at)));
  }
}

}  // namespace

std::string ResultCache::put(std::span<const std::byte> bytes, const Run& run) {
  ContentHash hash;
  in_pieces(bytes, run, [&](auto part) { hash.add_bytes(part); });
  std::string id = hash.hex();
  const fs::path path = blob_path(id);
  std::error_code ignored;
  if (fs::file_size(path, ignored) == bytes.size()) return id;
  AtomicFile file(path);
  in_pieces(bytes, run, [&](auto part) {
    file.stream().write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
  });
  file.commit();
  return id;
}

std::size_t ResultCache::size(const std::string& id) const {
  std::error_code problem;
  const auto bytes = fs::file_size(blob_path(id), problem);
  if (problem) throw failure("stored result: array " + id + " is gone");
  return bytes;
}

void ResultCache::get(const std::string& id, std::span<std::byte> into) const {
  std::ifstream in(blob_path(id), std::ios::binary);
  in.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
  if (in.gcount() != static_cast<std::streamsize>(into.size()) || content_hash(into) != id) {
    std::error_code ignored;
    fs::remove(blob_path(id), ignored);  // so that it is written anew
    throw failure("stored result: array " + id + " is damaged");
  }
}

std::optional<CachedResult> ResultCache::find(const std::string& key) {
  auto result = read_entry(result_path(key));
  if (!result || !all_there(result->files)) return std::nullopt;
  std::error_code ignored;
  for (const auto& [port, stored] : result->outputs)
    for (const auto& id : stored_blobs(stored))
      if (!fs::is_regular_file(blob_path(id), ignored)) return std::nullopt;
  fs::last_write_time(result_path(key), fs::file_time_type::clock::now(), ignored);  // for prune()
  return result;
}

std::map<std::string, std::string> ResultCache::store(const std::string& key, const std::string& stage_type,
                                                      const pipeline::StageResult& result,
                                                      const std::vector<WrittenFile>& files, const Run& run) {
  ordered_json entry{{"stage", stage_type},
                     {"report", pipeline::report_to_json(result.report)},
                     {"outputs", ordered_json::object()},
                     {"files", files_to_json(files)}};
  std::map<std::string, std::string> stored;
  PolledStore store(*this, run);
  for (const auto& [port, data] : result.outputs.all()) {
    stored[port] = store_data(data, store);
    entry["outputs"][port] = ordered_json::parse(stored[port]);
  }
  try {
    const auto body = entry.dump();
    ordered_json file{{"format", entry_format},
                      {"checksum", content_hash(std::as_bytes(std::span(body)))},
                      {"entry", std::move(entry)}};
    write_text_file(result_path(key), file.dump(1));
    return stored;
  } catch (const nlohmann::json::exception& e) {
    throw failure(std::string("a result cannot be stored: ") + e.what());
  }
}

void ResultCache::remove(const std::string& key) {
  std::error_code ignored;
  fs::remove(result_path(key), ignored);
}

std::uintmax_t ResultCache::prune(std::uintmax_t max_bytes) {
  struct Entry {
    fs::path path;
    fs::file_time_type used;
    std::vector<std::string> blobs;
  };
  std::error_code ignored;
  std::vector<Entry> entries;
  for (const auto& item : fs::directory_iterator(folder_ / "results", ignored)) {
    Entry entry{item.path(), item.last_write_time(ignored), {}};
    if (const auto result = read_entry(item.path()))
      for (const auto& [port, stored] : result->outputs)
        for (auto& id : stored_blobs(stored)) entry.blobs.push_back(std::move(id));
    entries.push_back(std::move(entry));
  }
  std::ranges::sort(entries, std::ranges::greater(), &Entry::used);
  // From the last used on: keep while the arrays that are kept stay within the budget.
  std::set<std::string> kept, dropped;
  std::uintmax_t kept_bytes = 0, removed_bytes = 0;
  for (const auto& entry : entries) {
    std::uintmax_t more = 0;
    for (const auto& id : entry.blobs)
      if (!kept.contains(id)) more += fs::exists(blob_path(id), ignored) ? fs::file_size(blob_path(id), ignored) : 0;
    if (kept_bytes + more > max_bytes) {
      fs::remove(entry.path, ignored);
      dropped.insert(entry.blobs.begin(), entry.blobs.end());
      continue;
    }
    kept_bytes += more;
    kept.insert(entry.blobs.begin(), entry.blobs.end());
  }
  // An array of the last minutes without a result may belong to one that another process is about to write.
  const auto young = fs::file_time_type::clock::now() - std::chrono::minutes(10);
  for (auto it = fs::recursive_directory_iterator(folder_ / "blobs", ignored); it != fs::recursive_directory_iterator();
       it.increment(ignored)) {
    const auto id = it->path().filename().string();
    if (!it->is_regular_file(ignored) || kept.contains(id)) continue;
    if (!dropped.contains(id) && it->last_write_time(ignored) > young) continue;
    const auto bytes = it->file_size(ignored);
    if (fs::remove(it->path(), ignored)) removed_bytes += bytes;
  }
  return removed_bytes;
}

}  // namespace bole::vtkbridge
