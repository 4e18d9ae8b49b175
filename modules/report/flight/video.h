// Videos by ffmpeg, where it is installed.
#pragma once

#include <filesystem>
#include <string>

#include "base/run.h"

namespace bole::report {

// The first program of that name in the folders of PATH; empty when there is none.
std::filesystem::path program_in_path(const std::string& name);

// From frame_00001.png, ... of `frames` to an MP4 that all players show (H.264, 4:2:0). Throws Error{failed} with what
// ffmpeg said, Error{cancelled}.
void write_video(const std::filesystem::path& ffmpeg, const std::filesystem::path& frames, double frame_rate,
                 const std::filesystem::path& video, const Run& run);

}  // namespace bole::report
