// What the fuzz targets share. A target defines write_seeds() and LLVMFuzzerTestOneInput(); `NAME_fuzz --seeds FOLDER`
// writes its seeds, so that they follow the format.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/atomic_file.h"
#include "base/error.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::fuzz {

// Small valid files of the format.
void write_seeds(const std::filesystem::path& folder);

inline void write_seed(const std::filesystem::path& folder, const char* name, std::string_view content) {
  write_text_file(folder / name, content);
}

// Whatever the bytes are, a reader gives a result or Error{bad_input}.
template <class Read>
void allow_bad_input(Read&& read) {
  try {
    read();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
  }
}

}  // namespace bole::fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  if (*count != 3 || std::string_view((*arguments)[1]) != "--seeds") return 0;
  const std::filesystem::path folder((*arguments)[2]);
  std::filesystem::create_directories(folder);
  bole::fuzz::write_seeds(folder);
  std::exit(0);
}
