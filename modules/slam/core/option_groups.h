// The parts of the option table whose defaults hold for every preset; options.cpp puts the table together.
#pragma once

#include <vector>

#include "slam/core/options.h"

namespace bole::slam {

using SlamOptionEntries = std::vector<OptionEntry<SlamOptions>>;

SlamOptionEntries registration_options();
SlamOptionEntries loop_options();
SlamOptionEntries map_options();

}  // namespace bole::slam
