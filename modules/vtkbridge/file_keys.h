// The content of input files as short keys. A file is read in full once; after that its path, size and time of change
// vouch for it, kept in a JSON file beside the cache, so that a raw scan of gigabytes is not read again at every start.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/run.h"

namespace bole {

class FileKeys {
 public:
  explicit FileKeys(std::filesystem::path memo_file);

  // The key of a file, or of a folder: names and contents of all files in it. A path that is not there has the key
  // "absent": the stage that reads it tells about it in its own words. Throws Error{cancelled}.
  std::string key(const std::filesystem::path& path, const Run& run = {});
  // Writes what was learnt.
  void save();

 private:
  struct Known {
    std::uintmax_t size = 0;
    std::int64_t changed_ns = 0;
    std::string key;
  };
  std::string file_key(const std::filesystem::path& path, const Run& run);
  std::filesystem::path memo_file_;
  std::map<std::string, Known> known_;
  bool changed_ = false;
};

std::int64_t change_time_ns(const std::filesystem::path& path);

}  // namespace bole
