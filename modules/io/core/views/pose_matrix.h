// Poses as datasets write them.
#pragma once

#include <string>
#include <vector>

#include "base/transform.h"

namespace bole::io {

// 16 numbers (4 x 4) or 12 (3 x 4), rows first. The rotation is made exactly orthonormal. Throws Error{bad_input} with
// `place` where it is no rigid motion to a thousandth.
Pose pose_from_matrix(const std::vector<double>& rows, const std::string& place);

// From axes as in OpenGL and Blender (x right, y up, z back) to those of a camera (x right, y down, z ahead).
Pose from_opengl(const Pose& T_world_opengl);

}  // namespace bole::io
