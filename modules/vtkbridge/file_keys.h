// The content of input files as short keys. Up to 64 MiB are read in full every time. A larger file or folder is read
// in full once; after that its path, size, inode, times of writing and of change, and of large files blocks from all
// over them, vouch for it, kept in a JSON file beside the cache, so that a raw scan of gigabytes is not read again at
// every start. The time of change (ctime) cannot be set back by a program, as the time of writing can.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/run.h"

namespace bole::vtkbridge {

class FileKeys {
 public:
  explicit FileKeys(std::filesystem::path memo_file);

  // The key of a file, or of a folder: names and contents of all files in it, and of the times that lie beside it,
  // which belong to the frames of a scan. imu.csv and NAME_imu.csv beside either belong to it as well. A path that is
  // not there has the key "absent": the stage that reads it tells about it in its own words. Throws Error{cancelled}.
  std::string key(const std::filesystem::path& path, const Run& run = {});
  // Writes what was learnt. A folder that cannot be written to costs time at the next run, nothing else.
  void save();

 private:
  struct Known {
    std::string stamp;  // size, inode, times
    std::string sample;
    std::string key;
  };
  std::string file_key(const std::filesystem::path& path, const Run& run, bool in_large_folder = false);
  std::filesystem::path memo_file_;
  std::map<std::string, Known> known_;
  bool changed_ = false;
};

// One spelling for a file or folder: absolute, without a slash at its end. A result in the cache knows its files by it.
std::filesystem::path whole_path(const std::filesystem::path& path);

// A text that differs once a file, or a file of a folder, has another name, size, inode or time. Reads no contents.
std::string change_stamp(const std::filesystem::path& path);

std::int64_t change_time_ns(const std::filesystem::path& path);

}  // namespace bole::vtkbridge
