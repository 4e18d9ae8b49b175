#include "base/exit_codes.h"

#include <array>

namespace bole {
inline namespace base {

std::span<const ExitCodeRow> exit_codes() {
  static constexpr std::array rows{
      ExitCodeRow{ExitCode::done, "done: every output was written"},
      ExitCodeRow{ExitCode::failed,
                  "failed: the work went wrong, an output could not be written, or an input could be "
                  "read in part only (--accept-partial)"},
      ExitCodeRow{ExitCode::bad_input, "bad input: a command, file, option or pipeline cannot be used as it is"},
      ExitCodeRow{ExitCode::cancelled, "cancelled on request: nothing was changed"},
      ExitCodeRow{ExitCode::finished_early,
                  "finished early on request (first Ctrl-C): outputs were written, of a result that is not complete"}};
  return rows;
}

}  // namespace base
}  // namespace bole
