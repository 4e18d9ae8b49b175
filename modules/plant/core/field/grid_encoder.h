// Density and colour on the lattice of the field's blocks, interpolated trilinearly before they are activated (as in
// DVGO, Sun et al. 2022: sharp surfaces inside a voxel).
#pragma once

#include "plant/core/field/field_encoder.h"

namespace bole::plant {

class GridEncoder : public FieldEncoder {
 public:
  struct Rates {
    float density = 0.25F, color = 0.1F;
    float smoothness = 1e-8F;  // of the density: pull towards the mean of the six neighbours
  };

  GridEncoder(std::shared_ptr<const FieldSpace> space, Rates rates, float density = -6);  // raw, of all voxels

  void forward(RayChunk& chunk, std::size_t first, std::size_t end) const override;
  void backward(RayChunk& chunk) const override;
  void accumulate(std::span<RayChunk> chunks) override;
  void update(const AdamStep& step) override;
  std::size_t parameter_count() const override;
  void visit_parameters(const std::function<void(std::span<float>)>& visit) override;
  void visit_moments(const std::function<void(std::span<float>)>& visit) override;
  std::vector<float> gradients() const override;

  // Raw values of a lattice point: density, red, green, blue.
  Eigen::Array4f& value(std::size_t box, std::size_t block, std::size_t voxel) {
    return boxes_[box].values[block * FieldBox::block_voxels + voxel];
  }
  // By index: block * 512 + voxel.
  const Eigen::Array4f& value_at(std::size_t box, std::size_t index) const { return boxes_[box].values[index]; }
  const Rates& rates() const { return rates_; }

 private:
  struct Values {
    std::vector<Eigen::Array4f> values, gradients, first, second;  // second: Adam's moments
    std::vector<std::int32_t> touched_in;                          // step in which the gradient was begun
    std::array<std::vector<std::uint32_t>, 8> touched;             // by parity of the lattice point
  };
  std::array<std::uint32_t, 8> corners(const FieldSample& sample) const;
  void accumulate_parity(std::span<RayChunk> chunks, int parity);
  void smooth(std::size_t box, std::uint32_t index);

  std::shared_ptr<const FieldSpace> space_;
  Rates rates_;
  std::vector<Values> boxes_;
  std::int32_t step_ = 1;
};

}  // namespace bole::plant
