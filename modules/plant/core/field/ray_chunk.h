// A handful of rays with their samples, rendered and differentiated together by one task.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "plant/core/field/field_space.h"

namespace bole::plant {

struct ChunkRay {
  FieldRay march;
  float footprint = 0.0016F;                        // width of a pixel at a distance of one metre, metres
  float z_per_t = 1;                                // depth along the camera's axis per metre along the ray
  float transmittance = 1;                          // behind the samples so far
  Eigen::Vector3f color = Eigen::Vector3f::Zero();  // without what is behind the last sample
  float depth = 0;                                  // sum of weight * t
  float median = -1;                                // t where the transmittance falls below one half; -1: nowhere
  std::int32_t last = -1;                           // last sample
};

struct ChunkSample {
  FieldSample place;
  std::int32_t ray = 0, previous = -1;  // of the chunk
  float before = 1, alpha = 0;          // transmittance in front; opacity
};

struct RayChunk {
  std::vector<ChunkRay> rays;
  std::vector<ChunkSample> samples;
  // By sample: what an encoder gives, and the derivative of the loss by it.
  std::vector<float> density, d_density;  // 1/m
  std::vector<Eigen::Vector3f> color, d_color;
  // By sample, where asked for: derivative of the loss by the position.
  bool wants_d_position = false;
  std::vector<Eigen::Vector3f> d_position;
  // An encoder's own: activations by sample, and gradients of the parameters that all samples share.
  std::vector<float> memory, gradient;

  void clear();
};

class FieldEncoder;

// Marches all rays of the chunk front to back until little light is left. Uses `rays[i].march` as it is.
void render_chunk(const FieldSpace& space, const FieldEncoder& encoder, RayChunk& chunk, float min_transmittance);

// Derivatives of a ray's loss by what the renderer gives.
struct RayGradient {
  Eigen::Vector3f color = Eigen::Vector3f::Zero();  // by color (of the samples)
  float transmittance = 0;                          // by what is left at the end
};

// Fills d_density and d_color. `weight_gradient(ray, t)` is the derivative of the loss by the weight of a sample beyond
// what goes through the colour. Call it after render_chunk().
template <class WeightGradient>
void differentiate_chunk(RayChunk& chunk, const std::vector<RayGradient>& gradients, WeightGradient weight_gradient);

}  // namespace bole::plant

#include "plant/core/field/ray_chunk_gradient.h"
