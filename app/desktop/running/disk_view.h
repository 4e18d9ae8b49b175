// Clouds that are too large for memory: which they are, and how they are opened to be looked at.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "document/disk_points.h"
#include "pipeline/document.h"

namespace bole::desktop {

// The LAS, LAZ or COPC file that a stage reads as it is (no part of it, in metres, z up), when its points take
// more than `memory_bytes`; nothing for others, and where the file cannot be read.
std::optional<std::filesystem::path> cloud_for_disk(const pipeline::StageNode& node, std::size_t memory_bytes);
// Whether a file that is read as it is is one: LAS, LAZ or COPC, in metres, and too large.
bool file_for_disk(const std::filesystem::path& cloud, std::size_t memory_bytes);

// What all points of a file would take in memory.
double bytes_in_memory(const io::LasInfo& info);

// Where the index of a cloud lies: it is made once, and anew when the file has changed.
std::filesystem::path index_of_cloud(const std::filesystem::path& cloud);

// A COPC file is opened as it is. Of others an index is built first, which takes a while and says how far it is. Throws
// bole::Error.
std::shared_ptr<DiskPoints> open_on_disk(const std::filesystem::path& cloud, std::size_t memory_bytes, const Run& run);

}  // namespace bole::desktop
