// Where the ground lies below the points of a survey, so that a cloud without heights above ground has some there.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "cloud/point_cloud.h"
#include "cloud/raster.h"

namespace bole::render {

class GroundBelow {
 public:
  // From an even share of the points that have a height above ground: each says where the ground is below it.
  explicit GroundBelow(const PointCloud& cloud);

  bool empty() const { return cells_.empty(); }
  // Not a number where no point of the survey is within a metre or two.
  double z_at(const Eigen::Vector2d& plan) const;
  // All of it as a terrain model of cells of a metre; none without any ground.
  Raster heights() const;

 private:
  struct Cell {
    double sum_z = 0;
    std::size_t count = 0;
  };
  std::unordered_map<std::uint64_t, Cell> cells_;  // of a metre
};

}  // namespace bole::render
