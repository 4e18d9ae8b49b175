#include "io/core/scans/beside_capture.h"

#include <fstream>
#include <iterator>

namespace bole::io {

std::string small_file_text(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::file_size(path, ignored) > max_bytes || ignored) return {};
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string plural(std::int64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace bole::io
