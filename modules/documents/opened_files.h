// Which files ParaView's File > Open gives to which reader, from the table of formats.
#pragma once

#include <map>
#include <string>

#include "pipeline/paraview_xml.h"

namespace bole::documents {

// By stage. Layouts of folders are not among them: ParaView opens files by their endings.
std::map<std::string, pipeline::OpenedFiles> opened_files();

}  // namespace bole::documents
