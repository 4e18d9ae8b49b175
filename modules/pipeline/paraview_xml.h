// The stages as ParaView server-manager XML, for a plugin that loads the VTK modules: sources, filters, their ports and
// options.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace bole::pipeline {

std::string paraview_xml(const StageRegistry& registry);

}  // namespace bole::pipeline
