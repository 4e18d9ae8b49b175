// The stand in three dimensions: stems and a thinned cloud that turn under the pointer.
#pragma once

#include <string>

namespace bole::report {

// The section with its tools; the script view3d.js draws into it.
std::string view3d_section(bool has_points, bool has_trees);

}  // namespace bole::report
