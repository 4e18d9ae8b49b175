// Opens the pictures of a camera.
#pragma once

#include <filesystem>
#include <memory>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "io/core/views/read_views_options.h"

namespace bole::io {

// A folder, or a file that stands for one (transforms.json, camera.json). Its layout is found by its files. The report
// gets counts (views, views_with_depth, poses, and what is missing), facts and findings. Throws Error{bad_input} where
// there is nothing to read.
std::shared_ptr<const ViewSource> open_views(const std::filesystem::path& path, const ReadViewsOptions& options,
                                             const Run& run, Report& report);
std::shared_ptr<const ViewSource> open_views(const std::filesystem::path& path, const ReadViewsOptions& options = {},
                                             const Run& run = {});

}  // namespace bole::io
