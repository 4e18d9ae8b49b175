// What this build is, for reports and `bole version`.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bole {
inline namespace base {

std::string_view version();

// Name and version of the libraries that the build used.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace base
}  // namespace bole
