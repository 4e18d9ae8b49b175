// Where a field has something: nested boxes around the region, the second twice as wide as the first and with voxels
// twice as large, each further one by four, each divided into blocks of 8 x 8 x 8 voxels of which only those near
// surfaces exist.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "plant/core/surface/region.h"

namespace bole::plant {

struct FieldBox {
  static constexpr int block_size = 8, block_voxels = 512;

  Eigen::Vector3f min = Eigen::Vector3f::Zero();  // metres from FieldSpace::origin
  float voxel = 0.001F;
  Eigen::Vector3i blocks = Eigen::Vector3i::Zero();
  std::vector<std::int32_t> block_of;  // of the box: (bx * ny + by) * nz + bz; -1: none
  // Of each block: its place, which of its 4 x 4 x 4 cells of two voxels are sampled (bit (x * 4 + y) * 4 + z), and the
  // blocks that begin at it and at its neighbours towards +x, +y, +z (index x * 4 + y * 2 + z).
  std::vector<Eigen::Vector3i> places;
  std::vector<std::uint64_t> cells;
  std::vector<std::array<std::int32_t, 8>> neighbours;

  Eigen::Vector3f max() const { return min + blocks.cast<float>() * (voxel * block_size); }
  std::size_t block_index(const Eigen::Vector3i& b) const {
    return (static_cast<std::size_t>(b.x()) * static_cast<std::size_t>(blocks.y()) + static_cast<std::size_t>(b.y())) *
               static_cast<std::size_t>(blocks.z()) +
           static_cast<std::size_t>(b.z());
  }
};

// A place on a ray where the field is asked.
struct FieldSample {
  float t = 0, step = 0;  // metres along the ray; length that the sample stands for
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  std::uint8_t box = 0;
  std::int32_t block = 0;   // of the box
  std::uint16_t voxel = 0;  // of the block, the lattice point below the sample: (x * 8 + y) * 8 + z
  Eigen::Vector3f within = Eigen::Vector3f::Zero();  // from that lattice point, in voxels
};

struct FieldRay {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero(), direction = Eigen::Vector3f::UnitZ();  // unit length
  float end = 0;                                                                           // where it leaves the space
  float at = 0;                                                                            // where the march goes on
  float jitter = 0.5F;                      // shift of the samples, in steps
  std::array<float, 4> enters{}, leaves{};  // of each box
};

struct FieldSpace {
  static constexpr int max_boxes = 4;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // world; positions of the field count from here
  std::vector<FieldBox> boxes;                       // from the inside out
  float step = 1;                                    // in voxels

  // `count` boxes around a region. No block exists yet.
  static FieldSpace around(const Region& region, double voxel, int count);

  // Creates the blocks of the sampled cells of box `box` (one mask per place of the box), and what interpolation needs
  // beside them.
  void set_cells(std::size_t box, const std::vector<std::uint64_t>& masks);

  FieldRay ray(const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float jitter) const;
  // The next sample on the ray, or false at its end.
  bool next(FieldRay& ray, FieldSample& sample) const;
  std::size_t block_count() const;
  float voxel_at(const Eigen::Vector3f& p) const;  // of the innermost box that holds p, or of the last box
};

}  // namespace bole::plant
