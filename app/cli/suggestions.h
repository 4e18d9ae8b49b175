// What was probably meant by a command or option that there is not.
#pragma once

#include <CLI/CLI.hpp>

namespace bole::cli {

// Throws Error{bad_input} with the nearest names when the arguments name a command or a long option that the program
// does not have. The parser's own messages say less.
void check_names(const CLI::App& app, int argc, const char* const* argv);

}  // namespace bole::cli
