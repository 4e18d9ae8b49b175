// The files of a simulated seedling.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/table.h"

namespace bole::sim {

// All throw Error{failed} that names the file.
void write_color(const std::filesystem::path& file, const ColorImage& image);
// 16 bit, `scale` units per metre; depths that do not fit become 0.
void write_depth(const std::filesystem::path& file, const DepthImage& depth, double scale);
void write_csv(const std::filesystem::path& file, const Table& table);
void write_json(const std::filesystem::path& file, const nlohmann::json& json);
// TUM: time, translation, quaternion (x, y, z, w). View i has the time i / 30 s.
void write_poses(const std::filesystem::path& file, const std::vector<Pose>& T_world_camera);

void write_camera(const std::filesystem::path& file, const RgbdCamera& camera);  // camera/camera_json.h
nlohmann::json mat_json();

}  // namespace bole::sim
