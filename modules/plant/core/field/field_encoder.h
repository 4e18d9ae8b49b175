// What turns a place into density and colour: the part of a field that learns.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plant/core/field/ray_chunk.h"

namespace bole::plant {

struct AdamStep {
  int step = 1;    // from 1
  float rate = 1;  // factor of the encoder's own learning rates
  float beta1 = 0.9F, beta2 = 0.99F, epsilon = 1e-12F;
};

class FieldEncoder {
 public:
  virtual ~FieldEncoder() = default;

  // Density and colour of the samples [first, end) of a chunk. May run in several threads, with a chunk each.
  virtual void forward(RayChunk& chunk, std::size_t first, std::size_t end) const = 0;
  // From d_density and d_color of all samples: d_position where asked for, and what accumulate() needs. In threads too.
  virtual void backward(RayChunk& chunk) const = 0;
  // Adds up the gradients of the chunks, in an order that does not depend on threads.
  virtual void accumulate(std::span<RayChunk> chunks) = 0;
  // One step of Adam along the gradients added up, which it clears.
  virtual void update(const AdamStep& step) = 0;

  // All parameters one after another, for checkpoints and tests.
  virtual std::size_t parameter_count() const = 0;
  virtual void visit_parameters(const std::function<void(std::span<float>)>& visit) = 0;
  // What Adam remembers of the gradients before, as many numbers twice: with the parameters all that update() changes.
  virtual void visit_moments(const std::function<void(std::span<float>)>& visit) = 0;
  // The gradients added up, in the order of the parameters. Slow: for tests.
  virtual std::vector<float> gradients() const = 0;
};

// Density of a raw value: softplus, in units of one per voxel.
inline float softplus(float x) { return x > 15 ? x : std::log1p(std::exp(x)); }
inline float sigmoid(float x) { return 1 / (1 + std::exp(-x)); }

}  // namespace bole::plant
