#include "base/resources.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

#include "base/error.h"

namespace bole {
inline namespace base {

namespace {

// Beside the library that this is part of, where it was installed; empty in a folder of the build.
std::filesystem::path installed_resource_dir() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&resource_dir), &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code error;
  const auto library = std::filesystem::canonical(info.dli_fname, error);
  const auto folder = (library.parent_path() / BOLE_RESOURCES_FROM_LIBRARIES).lexically_normal();
  return !error && std::filesystem::is_directory(folder, error) ? folder : std::filesystem::path();
}

}  // namespace

std::filesystem::path resource_dir() {
  if (const char* set = std::getenv("BOLE_RESOURCE_DIR"); set != nullptr && *set != '\0') return set;
  static const auto installed = installed_resource_dir();
  return installed.empty() ? std::filesystem::path(BOLE_RESOURCE_DIR) : installed;
}

std::filesystem::path resource_path(std::string_view relative) {
  auto path = resource_dir() / relative;
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw bad_input("there is no '" + path.string() + "'", "a file that comes with Bole",
                    "Set the environment variable BOLE_RESOURCE_DIR to the folder 'resources' of Bole");
  return path;
}

}  // namespace base
}  // namespace bole
