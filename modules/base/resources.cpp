#include "base/resources.h"

#include <cstdlib>
#include <string>

#include "base/error.h"

namespace bole {

std::filesystem::path resource_dir() {
  const char* set = std::getenv("BOLE_RESOURCE_DIR");
  return set != nullptr && *set != '\0' ? std::filesystem::path(set) : std::filesystem::path(BOLE_RESOURCE_DIR);
}

std::filesystem::path resource_path(std::string_view relative) {
  const auto path = resource_dir() / relative;
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw bad_input("there is no '" + path.string() + "'", "a file that comes with Bole",
                    "Set the environment variable BOLE_RESOURCE_DIR to the folder 'resources' of Bole");
  return path;
}

}  // namespace bole
