// A COPC file made of a LAS or LAZ file of any size: what a viewer reads in parts.
#pragma once

#include <filesystem>

#include "base/report.h"
#include "base/run.h"
#include "io/core/copc/copc_build.h"

namespace bole::io::copc {

// The points of `cloud` with all their fields but waveforms, its coordinate system, extra bytes and facts as `path`.
// Records of the formats 0 to 5 become those of 6 to 8, which COPC asks for. Throws Error{bad_input} for files of other
// formats, and what build_copc() throws.
BuiltFile index_cloud(const std::filesystem::path& cloud, const std::filesystem::path& path,
                      const std::filesystem::path& scratch, const BuildOptions& options = {}, const Run& run = {},
                      Report* report = nullptr);

}  // namespace bole::io::copc
