// The stages as ParaView server-manager XML, for a plugin that loads the VTK modules: sources, filters, their ports and
// options.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace bole::pipeline {

// The thin VTK class that names this stage, or vtkBoleStage, which is told the type.
std::string vtk_class_of_stage(std::string_view stage_type);

std::string paraview_xml(const StageRegistry& registry);

}  // namespace bole::pipeline
