// The option table in parts; options.cpp puts it together.
#pragma once

#include <vector>

#include "slam/core/options.h"

namespace bole::slam {

using SlamOptionEntries = std::vector<OptionEntry<SlamOptions>>;

SlamOptionEntries general_options();
SlamOptionEntries preset_options();  // those that a preset decides
SlamOptionEntries registration_options();
SlamOptionEntries inertial_options();
SlamOptionEntries loop_options();
SlamOptionEntries map_options();

}  // namespace bole::slam
