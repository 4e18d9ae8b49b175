// Reads a cloud and looks at it: what the file does not say (unit, up axis) is taken from the cloud where it is
// certain, and what a person must know of the cloud becomes findings.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "cloud/first_sight.h"
#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

enum class LevelCloud { none, stems };
constexpr std::array<std::string_view, 2> choice_names(LevelCloud) { return {"none", "stems"}; }

struct SeeCloudOptions {
  std::optional<LengthUnit> unit;  // open: metre, unless another one is certain
  std::optional<UpAxis> up;        // open: z, unless another one is certain
  LevelCloud level = LevelCloud::none;
  CloudReadOptions reading;  // its unit and up are not used
};
const OptionTable& option_table(const SeeCloudOptions*);

struct SeenCloud {
  CloudReading reading;  // with findings, and the fact `kind` of a single tree
  FirstSight sight;      // of the cloud as it was read, turned and scaled
  // Of the points before anything was turned or scaled; empty where there are none.
  Eigen::AlignedBox3d bounds{};
};

// As read_cloud(), with unit and up decided where the options leave them open.
SeenCloud see_cloud(const std::filesystem::path& path, const SeeCloudOptions& options = {}, const Run& run = {});

// The same of a cloud in memory, by take_cloud().
SeenCloud see_cloud(const PointCloud& given, const SeeCloudOptions& options = {}, const Run& run = {});

// One piece of the cloud that the first form gives; all pieces have one origin. Of LAS, LAZ and COPC files each piece
// is decoded by itself where the options leave nothing to be decided by the cloud (unit, up, level); else the whole
// cloud is read and looked at, so that all pieces agree. Piece 0 of another format is the whole cloud.
CloudReading read_piece(const std::filesystem::path& path, const Piece& piece, const SeeCloudOptions& options = {},
                        const Run& run = {});

// The second step of it, for a cloud that was read with the options.
SeenCloud look_at_cloud(CloudReading reading, const SeeCloudOptions& options, const Run& run = {});

}  // namespace bole::io
