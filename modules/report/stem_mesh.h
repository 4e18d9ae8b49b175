// Fitted stems as files for programs that draw solids: Wavefront OBJ, PLY and VTK XML.
#pragma once

#include <string>
#include <vector>

#include "render/scene/stem_shapes.h"

namespace bole::report {

// Every stem as a closed tapered tube of 24 sides about its axis. Texts of whole files; coordinates are those of the
// stem table, in full.
std::string stems_obj(const std::vector<render::StemShape>& stems);  // one object per tree, named tree_ID
std::string stems_ply(const std::vector<render::StemShape>& stems);  // faces with the property tree_id
std::string stems_vtp(const std::vector<render::StemShape>& stems);  // cells with the array tree_id

// The axes as lines: cells with tree_id, points with radius_m. VTK XML.
std::string stem_curves_vtp(const std::vector<render::StemShape>& stems);

}  // namespace bole::report
