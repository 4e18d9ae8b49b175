#include "base/core/path_list.h"

#include <algorithm>

namespace bole {
inline namespace base {

bool is_path_list(const OptionSpec& spec) {
  return spec.text_kind == TextKind::input_path && spec.choices == std::vector<std::string>{path_separator};
}

std::vector<std::string> input_paths(const OptionSpec& spec, std::string_view value) {
  if (!is_path_list(spec)) return {std::string(value)};
  std::vector<std::string> paths;
  for (std::size_t at = 0; at <= value.size();) {
    const auto end = std::min(value.find(path_separator, at), value.size());
    const auto path = value.substr(at, end - at);
    const auto first = path.find_first_not_of(' ');
    if (first != std::string_view::npos) paths.emplace_back(path.substr(first, path.find_last_not_of(' ') + 1 - first));
    at = end + 1;
  }
  return paths;
}

}  // namespace base
}  // namespace bole
