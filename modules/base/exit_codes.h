// The exit codes of the program: the one place where they are listed.
#pragma once

#include <span>
#include <string_view>

namespace bole {
inline namespace base {

enum class ExitCode { done = 0, failed = 1, bad_input = 2, cancelled = 3, finished_early = 4 };

struct ExitCodeRow {
  ExitCode code;
  std::string_view meaning;
};

// For help, manual page and documentation.
std::span<const ExitCodeRow> exit_codes();

}  // namespace base
}  // namespace bole
