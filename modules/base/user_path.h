// Paths as people type them.
#pragma once

#include <string>
#include <string_view>

namespace bole {
inline namespace base {

// "~" and "~/..." with the home folder in place of "~", "~name" with that of a user; other paths as they are. A shell
// does this at the beginning of a word only, not in --out=~/x or --set scan.file=~/x.
std::string expand_home(std::string_view path);

}  // namespace base
}  // namespace bole
