#include "plant/core/field/ray_chunk.h"

#include <cmath>

#include "plant/core/field/field_encoder.h"

namespace bole::plant {

void RayChunk::clear() {
  rays.clear();
  samples.clear();
  density.clear();
  d_density.clear();
  color.clear();
  d_color.clear();
  d_position.clear();
  memory.clear();
  gradient.clear();
}

void render_chunk(const FieldSpace& space, const FieldEncoder& encoder, RayChunk& chunk, float min_transmittance) {
  // In waves: encoders with matrices want many samples at once, and samples behind a surface are not worth asking.
  constexpr int samples_per_wave = 8;
  std::vector<std::int32_t> alive(chunk.rays.size());
  for (std::size_t i = 0; i < alive.size(); ++i) alive[i] = static_cast<std::int32_t>(i);
  while (!alive.empty()) {
    const std::size_t first = chunk.samples.size();
    std::size_t kept = 0;
    for (const auto r : alive) {
      auto& ray = chunk.rays[static_cast<std::size_t>(r)];
      int found = 0;
      ChunkSample sample;
      sample.ray = r;
      for (; found < samples_per_wave && space.next(ray.march, sample.place); ++found) {
        sample.previous = ray.last;
        ray.last = static_cast<std::int32_t>(chunk.samples.size());
        chunk.samples.push_back(sample);
      }
      if (found == samples_per_wave) alive[kept++] = r;
    }
    alive.resize(kept);
    const std::size_t end = chunk.samples.size();
    chunk.density.resize(end);
    chunk.color.resize(end);
    encoder.forward(chunk, first, end);
    for (std::size_t i = first; i < end; ++i) {
      auto& sample = chunk.samples[i];
      auto& ray = chunk.rays[static_cast<std::size_t>(sample.ray)];
      sample.before = ray.transmittance;
      sample.alpha = 1 - std::exp(-chunk.density[i] * sample.place.step);
      const float weight = sample.before * sample.alpha;
      ray.color += weight * chunk.color[i];
      ray.depth += weight * sample.place.t;
      const float after = sample.before - weight;
      if (ray.median < 0 && after < 0.5F)
        // Within the sample the light falls off exponentially.
        ray.median = sample.place.t + sample.place.step * (std::log(std::max(1e-6F, sample.before / 0.5F)) /
                                                               std::max(1e-6F, chunk.density[i] * sample.place.step) -
                                                           0.5F);
      ray.transmittance = after;
    }
    std::erase_if(alive, [&](std::int32_t r) {
      return chunk.rays[static_cast<std::size_t>(r)].transmittance < min_transmittance;
    });
  }
}

}  // namespace bole::plant
