// Where the files that come with Bole lie: sensor tables, plot recipes, colour maps.
#pragma once

#include <filesystem>
#include <string_view>

namespace bole {
inline namespace base {

// The resources folder: the environment variable BOLE_RESOURCE_DIR when set, else that of the build or installation.
std::filesystem::path resource_dir();

// A file or folder in it: resource_path("sensors/vlp16.json"). Throws Error{bad_input} that names the full path when
// absent.
std::filesystem::path resource_path(std::string_view relative);

}  // namespace base
}  // namespace bole
