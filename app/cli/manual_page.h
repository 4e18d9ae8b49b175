// The manual page bole(1), for man.
#pragma once

#include <string>
#include <vector>

#include "command_table.h"

namespace bole::cli {

std::string manual_page(const std::string& description, const std::vector<CommandEntry>& commands);

// The table of exit codes as text, a line each: for help and for the manual page.
std::string exit_codes_text();

}  // namespace bole::cli
