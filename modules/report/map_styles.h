// How the layers of plot.gpkg look when QGIS opens them: styles as QML.
#pragma once

#include <string>

#include "cloud/table.h"

namespace bole::report {

// Circles of twice the diameter at breast height, in the colours of the quality where the table has one, labelled with
// number and diameter.
std::string stem_style(const Table& stems);
// Points without labels, small where there are many.
std::string candidate_style();
std::string section_style();
std::string target_style();
std::string boundary_style();
std::string trajectory_style();

}  // namespace bole::report
