// The camera of a folder of views: its own file, or the option `camera`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/report.h"
#include "camera/camera_model.h"

namespace bole::io {

// Cameras that many recordings were made with, by name: tum_freiburg1, tum_freiburg2, tum_freiburg3, icl_nuim,
// primesense. Sources: the web page of the TUM RGB-D benchmark, ICL-NUIM, Open3D's default.
const RgbdCamera* known_camera(std::string_view name);
std::string known_camera_names();  // "tum_freiburg1, ..."

// `choice` is the option: a file, "fx,fy,cx,cy", a known name, "unknown" (fx = 0: a guess by the size of the images, to
// be calibrated), or empty for `own`, a file that may be absent or unnamed. Throws Error{bad_input} that says how to
// give a camera.
RgbdCamera chosen_camera(const std::string& choice, const std::filesystem::path& own, bool with_depth, Report& report);

}  // namespace bole::io
