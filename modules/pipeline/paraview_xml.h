// The stages as ParaView server-manager XML, for a plugin that loads the VTK modules: sources, filters, their ports and
// options.
#pragma once

#include <map>
#include <string>

#include "pipeline/stage.h"

namespace bole::pipeline {

// The files that ParaView's File > Open gives to a reader.
struct OpenedFiles {
  std::string extensions;   // "laz las", as ParaView writes them
  std::string description;  // "Point cloud (Bole)"
};

// `opened`: by stage.
std::string paraview_xml(const StageRegistry& registry, const std::map<std::string, OpenedFiles>& opened = {});

// "Height (m)": the name of an option as a person reads it, with its unit.
std::string paraview_label(const OptionSpec& spec);

}  // namespace bole::pipeline
