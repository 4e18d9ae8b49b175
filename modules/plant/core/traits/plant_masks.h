// Where pictures show the plant, told by its colours.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/run.h"
#include "cloud/core/view_source.h"
#include "plant/core/separate/point_grid.h"
#include "plant/core/traits/depth_picture.h"

namespace bole::plant {

// One picture in cells of a few pixels, one pixel more than what has the colours of the plant.
struct PlantMask {
  CameraModel camera;
  Pose T_camera_plant;
  DepthPicture others;  // what is not the plant
  int cell_px = 1, columns = 0, rows = 0;
  std::vector<std::uint8_t> cells;

  bool shows_plant(const Eigen::Vector2d& pixel) const;
};

struct PlantMasks {
  bool told = false;        // whether colours tell the plant from what is around it; else there are no masks
  double plant_taken = 0;   // share of the pixels with points of the plant that have its colours
  double others_taken = 0;  // share of the other pixels that have them
  std::vector<PlantMask> views;
};

struct MaskInputs {
  const ViewSource* views = nullptr;
  const Trajectory* poses = nullptr;  // T_world_camera
  Pose T_plant_world = Pose::Identity();
  const Points3* plant = nullptr;   // plant axes
  const Points3* others = nullptr;  // pot, soil, mat and what else stands around
  double spacing = 0;
};

// Learns the colours in a dozen pictures from the points of the plant that they show and from what lies away from it,
// then marks all views of `which`. Points beside the plant (a cloud of depth has them) spoil a part of the first, parts
// that the cloud lacks a part of the second: neither is most of it.
PlantMasks plant_masks(const MaskInputs& inputs, const std::vector<std::uint32_t>& which, const Run& run);

}  // namespace bole::plant
