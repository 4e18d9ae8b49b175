// The connected parts of a cloud, and which of them are the plant.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/run.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct PartSearch {
  double link = 0;                                   // points nearer than this are connected
  double max_gap = 0;                                // parts with many points may be this far from the plant
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // of the pot, or where the plant is expected
  double reach = 0;                                  // the plant comes within this distance of the centre; 0: anywhere
  double soil_height = 0;
};

struct PlantParts {
  // Per point: 1 plant, 0 small unconnected part, 2 large unconnected part.
  std::vector<std::uint8_t> kind;
  std::size_t parts = 0, joined = 0;  // joined across gaps
  double widest_gap = 0;              // of those joined
  double soil_gap = 0;                // between the plant and the soil
};

// `level`: points above the soil, z up, without pot and mat. The plant is the part that grows out of the soil near the
// centre, and all that is connected with it.
PlantParts plant_parts(const Points3& level, const PartSearch& search, const Run& run);

// Where the stem leaves the soil, from the plant's points: the upright strand nearest to the centre.
struct FoundBase {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double sd = 0;
};
std::optional<FoundBase> find_base(const Points3& plant, const Eigen::Vector2d& centre, double soil_height, double unit,
                                   double link);

}  // namespace bole::plant
