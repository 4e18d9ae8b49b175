// Pipelines that come with Bole, and the one that fits a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/document.h"

namespace bole::documents {

// The folder of the pipelines that come with Bole, beside its resources (base/resources.h), in the source tree and in
// an installation.
std::filesystem::path pipelines_dir();

// Their names, "stem_map_from_cloud" and others, sorted. Empty where the folder is missing.
std::vector<std::string> shipped_pipelines();

// One of them, with or without ".json". Throws Error{bad_input} with the nearest names.
pipeline::PipelineDocument shipped_pipeline(std::string_view name);

// A pipeline as a person names it: a path, or one of shipped_pipelines() where no file has that path. Throws
// Error{bad_input}; of a scan or cloud it says that `bole survey` takes it.
pipeline::PipelineDocument load_pipeline(const std::string& path_or_name);

// A survey of a scan (file or folder), a stem map of a point cloud: the shipped pipeline that fits, with this file.
// Throws Error{bad_input} for other files.
pipeline::PipelineDocument document_for_file(const std::filesystem::path& path);

// The traits of a plant from a folder of views, or the file that describes them; where that pipeline does not come with
// this Bole, one that reads the views. Errors come when it runs.
pipeline::PipelineDocument document_for_views(const std::filesystem::path& path);

}  // namespace bole::documents
