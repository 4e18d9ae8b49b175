// Options that name several files or folders.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/option.h"

namespace bole {
inline namespace base {

// An option of the kind input_path takes several paths where its choices are this separator:
// Option<S, std::string>{"folders", &S::folders, TextKind::input_path, {path_separator}, ...}.
inline constexpr const char* path_separator = ",";
bool is_path_list(const OptionSpec& spec);

// The paths of a value with is_input_path(), without the blanks around them; one unless the option is a list.
std::vector<std::string> input_paths(const OptionSpec& spec, std::string_view value);

}  // namespace base
}  // namespace bole
