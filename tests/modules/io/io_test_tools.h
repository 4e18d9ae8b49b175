// What the tests of the module io share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "checks.h"
#include "io/core/bytes/mapped_file.h"
#include "real_data.h"

namespace bole::testing_io {

using testing_checks::error_of;
using testing_checks::file_text;

inline std::filesystem::path shared(const std::string& relative) {
  return std::filesystem::path(BOLE_SHARED_DATA_DIR) / relative;
}

// Skips the test when a folder of real files is absent.
#define BOLE_NEEDS_SHARED(folder) BOLE_NEEDS_REAL(bole::testing_io::shared(folder))

// A folder of its own that goes away with the object.
class TempDir {
 public:
  TempDir()
      : path_(std::filesystem::temp_directory_path() /
              ("bole_io_" + std::to_string(::getpid()) + "_" + std::to_string(counter()++))) {
    std::filesystem::create_directories(path_);
  }
  ~TempDir() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  static int& counter() {
    static int count = 0;
    return count;
  }
  std::filesystem::path path_;
};

inline io::Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

inline void write_file(const std::filesystem::path& path, const std::string& content) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << content;
}

}  // namespace bole::testing_io
