// Opens the capture of an Ouster sensor with the JSON file that belongs to it.
#pragma once

#include <filesystem>
#include <memory>

#include "io/core/bytes/mapped_file.h"
#include "io/core/scans/ouster_source.h"

namespace bole::io {

// Whether the first packets of a capture are those of an Ouster sensor: by their length and the marks in them.
bool looks_like_ouster_capture(Bytes capture);

// The metadata of a capture: the JSON file that the option sensor names; else the one with the same name as the
// capture; else the one Ouster JSON file in its folder whose packets are as long as those of the capture. Throws
// Error{bad_input} that says what was found where that does not leave one.
sensor::OusterMetadata find_ouster_metadata(const std::filesystem::path& capture, const std::string& sensor_option,
                                            Report& report);

std::shared_ptr<const FrameSource> open_ouster_capture(const std::filesystem::path& path,
                                                       const FrameSourceOptions& options, const Run& run,
                                                       Report& report);

}  // namespace bole::io
