#include "base/version.h"

#include <Eigen/Core>

namespace bole {
inline namespace base {

std::string_view version() { return BOLE_VERSION; }

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::vector<std::pair<std::string, std::string>> list;
  // BOLE_LIBRARY_VERSIONS is "name version;name version;...", written by the build from what it found.
  std::string_view rest = BOLE_LIBRARY_VERSIONS;
  while (!rest.empty()) {
    const auto end = rest.find(';');
    const auto entry = rest.substr(0, end);
    if (const auto space = entry.find(' '); space != std::string_view::npos && space + 1 < entry.size())
      list.emplace_back(entry.substr(0, space), entry.substr(space + 1));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  return list;
}

}  // namespace base
}  // namespace bole
