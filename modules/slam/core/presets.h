// The systems that the engine can be: which value each preset gives the options that are left to it.
#pragma once

#include <string>
#include <vector>

namespace bole::slam {

// In the order of the table.
const std::vector<std::string>& preset_names();

}  // namespace bole::slam
