// Results of stages on disk, by the key of all that they depend on.
//
//   DIR/results/<key>.json   stage type, report, outputs, files that a sink wrote
//   DIR/blobs/ab/<hash>      arrays, each named by its content and kept once
//   DIR/files.json           keys of input files (file_keys.h)
//
// Entries are written atomically and checked when read; a damaged one counts as absent. Several processes may use a
// folder.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "cloud/serialize.h"
#include "pipeline/stage.h"
#include "vtkbridge/file_keys.h"

namespace bole::vtkbridge {

struct WrittenFile {
  std::string path;
  std::uintmax_t size = 0;
  std::int64_t changed_ns = 0;
};

// The files in a folder, the cache apart.
std::vector<WrittenFile> list_files(const std::filesystem::path& folder, const std::filesystem::path& except);
// Those of `after` that `before` does not have, or has otherwise.
std::vector<WrittenFile> changed_files(const std::vector<WrittenFile>& before, const std::vector<WrittenFile>& after);
bool all_there(const std::vector<WrittenFile>& files);

struct CachedResult {
  Report report;
  std::map<std::string, std::string> outputs;  // port -> JSON of store_data()
  std::vector<WrittenFile> files;
};

class ResultCache : private BlobStore {
  class PolledStore;

 public:
  // The folder is made when the first result is stored.
  explicit ResultCache(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }

  std::string file_key(const std::filesystem::path& path, const Run& run = {});

  // The result under a key, when all its parts are there; its arrays are checked when they are loaded.
  std::optional<CachedResult> find(const std::string& key);
  // Returns what load() takes, per port. Throws Error{cancelled} among others.
  std::map<std::string, std::string> store(const std::string& key, const std::string& stage_type,
                                           const pipeline::StageResult& result, const std::vector<WrittenFile>& files,
                                           const Run& run = {});
  void remove(const std::string& key);
  // Throws Error{failed} when an array is damaged.
  Data load(const std::string& stored, const SourceOpener& open_source) const {
    return load_data(stored, *this, open_source);
  }

  // Removes the results not used for longest until the folder holds at most `max_bytes`. Returns the bytes removed.
  std::uintmax_t prune(std::uintmax_t max_bytes);

 private:
  std::string put(std::span<const std::byte> bytes) override { return put(bytes, {}); }
  std::string put(std::span<const std::byte> bytes, const Run& run);
  std::size_t size(const std::string& id) const override;
  void get(const std::string& id, std::span<std::byte> into) const override;
  std::filesystem::path blob_path(const std::string& id) const;
  std::filesystem::path result_path(const std::string& key) const;

  std::filesystem::path folder_;
  FileKeys file_keys_;
  std::mutex mutex_;
};

}  // namespace bole::vtkbridge
