// Truncated signed distances (Curless and Levoy 1996) in sparse blocks of voxels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/run.h"
#include "plant/core/surface/posed_views.h"
#include "plant/core/surface/region.h"

namespace bole::plant {

struct FuseOptions {
  double voxel = 0.001;
  std::optional<double> truncation;  // metres
  double depth_sigma = 0.0015;       // at 0.5 m
  double min_weight = 2;
  double min_share = 0.6;
  std::string region;
  bool mesh = false;
  int max_memory_mib = 1500;
};
const OptionTable& option_table(const FuseOptions*);

struct Voxel {
  float distance = 0;                  // metres along the line of sight to the surface; negative behind it
  float weight = 0;                    // 0: nothing known
  float red = 0, green = 0, blue = 0;  // 0 to 255
};

// Voxels of 8 x 8 x 8 blocks near the surfaces. Lattice point (x, y, z) lies at origin + voxel * (x, y, z).
struct Tsdf {
  static constexpr int block_size = 8;
  static constexpr int block_voxels = block_size * block_size * block_size;

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double voxel = 0.001;
  double truncation = 0.004;
  Eigen::Vector3i blocks = Eigen::Vector3i::Zero();  // of the whole region
  std::vector<std::int32_t> block_of;                // by (bx * ny + by) * nz + bz; -1: none
  std::vector<Eigen::Vector3i> places;               // of the blocks that there are
  std::vector<Voxel> voxels;                         // block after block; ((x * 8) + y) * 8 + z within

  Eigen::Vector3i lattice() const { return blocks * block_size; }
  // The voxel at a lattice point, or null where there is no block.
  const Voxel* find(int x, int y, int z) const;
  Eigen::Vector3d position(int x, int y, int z) const { return origin + voxel * Eigen::Vector3d(x, y, z); }
  // Distance at a place (trilinear) and its gradient; nothing where a corner is unknown.
  std::optional<float> distance_at(const Eigen::Vector3d& p) const;
};

// Fuses the depth of the views. `report` gets counts and metrics, and a finding where the voxels had to be larger than
// asked for. Throws Error{bad_input} without depth.
Tsdf fuse_depth(const ViewSource& views, const std::vector<PosedView>& posed, const Region& region,
                const FuseOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
