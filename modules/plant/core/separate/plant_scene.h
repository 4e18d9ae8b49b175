// What is known of the scene around a plant: which way is up, where the soil is, where the stem begins.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cloud/facts.h"

namespace bole::plant {

// What a point belongs to: the values of the column `part`.
enum class Part : std::int32_t { other = 0, plant = 1, pot = 2, soil = 3, mat = 4, floater = 5 };
constexpr std::array<std::string_view, 6> choice_names(Part) {
  return {"other", "plant", "pot", "soil", "mat", "floater"};
}
inline constexpr std::string_view part_column = "part";

// All places and directions are in the axes of the cloud, lengths in its unit (metres where scale_known).
struct PlantScene {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // unit
  std::string up_source = "assumed";              // board, option, plane, assumed
  bool scale_known = true;
  std::string soil_source = "none";  // pot, plane, table, lowest_point, option
  // The soil near the stem: soil_normal . p = soil_offset. The normal has up . normal > 0 and length 1.
  Eigen::Vector3d soil_normal = Eigen::Vector3d::UnitZ();
  double soil_offset = 0;
  double soil_sd = 0;                              // standard error of the height of the soil at the stem
  Eigen::Vector3d base = Eigen::Vector3d::Zero();  // where the stem leaves the soil
  double base_sd = 0;                              // in plan
  std::string base_source = "found";               // found, option, pot_axis, lowest_point
  // The pot, a cone about the direction `up`: radii at the rim and at the foot. Zero radii: none found.
  Eigen::Vector3d pot_rim = Eigen::Vector3d::Zero(), pot_foot = Eigen::Vector3d::Zero();
  double rim_radius = 0, foot_radius = 0;
  std::optional<double> table_height;  // up . p of the table or mat

  // Height of the soil below or above a place, measured along `up`.
  double soil_height_at(const Eigen::Vector3d& place) const;
};

void put_scene(Facts& facts, const PlantScene& scene);

// Throws Error{bad_input} where the facts are not those of plant.separate.
PlantScene scene_of(const Facts& facts);

// Rotation that takes `up` to z.
Eigen::Matrix3d levelling(const Eigen::Vector3d& up);

}  // namespace bole::plant
