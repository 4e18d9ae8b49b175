// The derivative of volume rendering, as a template so that the loss is inlined.
#pragma once

#include <algorithm>

#include "plant/core/field/ray_chunk.h"

namespace bole::plant {

template <class WeightGradient>
void differentiate_chunk(RayChunk& chunk, const std::vector<RayGradient>& gradients, WeightGradient weight_gradient) {
  chunk.d_density.assign(chunk.samples.size(), 0);
  chunk.d_color.assign(chunk.samples.size(), Eigen::Vector3f::Zero());
  for (std::size_t r = 0; r < chunk.rays.size(); ++r) {
    const auto& ray = chunk.rays[r];
    const auto& gradient = gradients[r];
    // Sum over what lies behind of weight * derivative by weight; the background is the last of it.
    float behind = ray.transmittance * gradient.transmittance;
    for (std::int32_t s = ray.last; s >= 0; s = chunk.samples[static_cast<std::size_t>(s)].previous) {
      const auto i = static_cast<std::size_t>(s);
      const auto& sample = chunk.samples[i];
      const float weight = sample.before * sample.alpha;
      const float by_weight = gradient.color.dot(chunk.color[i]) + weight_gradient(r, sample.place.t);
      const float after = sample.before * (1 - sample.alpha);
      chunk.d_density[i] = sample.place.step * (after * by_weight - behind);
      chunk.d_color[i] = weight * gradient.color;
      behind += weight * by_weight;
    }
  }
}

}  // namespace bole::plant
