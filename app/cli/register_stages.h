// Makes the stages of all modules known to the program.
#pragma once

namespace bole::cli {

void register_stages();

}  // namespace bole::cli
