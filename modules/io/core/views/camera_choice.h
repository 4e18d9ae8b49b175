// The camera of a folder of views: its own file, or the option `camera`.
#pragma once

#include <filesystem>
#include <string>

#include "base/report.h"
#include "camera/camera_model.h"

namespace bole::io {

// `choice` is the option: a file, "fx,fy,cx,cy", or empty for `own`, a file that may be absent. Throws Error{bad_input}
// that says how to give a camera.
RgbdCamera chosen_camera(const std::string& choice, const std::filesystem::path& own, bool with_depth, Report& report);

}  // namespace bole::io
