// The exit codes of the program: the one place where they are listed.
#pragma once

#include <array>
#include <string_view>

namespace bole {
inline namespace base {

enum class ExitCode { done = 0, failed = 1, bad_input = 2, cancelled = 3, finished_early = 4 };

struct ExitCodeRow {
  ExitCode code;
  std::string_view meaning;
};

// For help, manual page and documentation.
inline constexpr std::array exit_codes{
    ExitCodeRow{ExitCode::done, "done: every output was written"},
    ExitCodeRow{ExitCode::failed,
                "failed: the work went wrong, an output could not be written, or an input could be "
                "read in part only (--accept-partial)"},
    ExitCodeRow{ExitCode::bad_input, "bad input: a command, file, option or pipeline cannot be used as it is"},
    ExitCodeRow{ExitCode::cancelled, "cancelled on request: nothing was changed"},
    ExitCodeRow{ExitCode::finished_early,
                "finished early (first Ctrl-C, or SLAM lost the track): outputs were written, of a result that is not "
                "complete"}};

}  // namespace base
}  // namespace bole
