// Scripts that complete commands, options and their values in a shell.
#pragma once

#include <string>
#include <vector>

#include "command_table.h"

namespace bole::cli {

std::string bash_completion(const std::vector<CommandEntry>& commands);
std::string zsh_completion(const std::vector<CommandEntry>& commands);
std::string fish_completion(const std::vector<CommandEntry>& commands);

}  // namespace bole::cli
