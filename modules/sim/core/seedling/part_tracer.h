// Rays against the parts of a scene.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/core/seedling/scene_part.h"

namespace bole::sim {

// Eight rays that lie close together. Directions need no unit length; distances are in lengths of the direction.
struct RayPack {
  static constexpr int size = 8;
  float origin[3][size];
  float direction[3][size];
  std::array<bool, size> active{true, true, true, true, true, true, true, true};

  void set(int lane, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    for (int k = 0; k < 3; ++k) {
      origin[k][lane] = static_cast<float>(from[k]);
      direction[k][lane] = static_cast<float>(along[k]);
    }
  }
};

struct PartHit {
  int part = -1;  // -1: nothing
  std::uint32_t triangle = 0;
  float distance = 0;
  float b = 0, c = 0;  // weights of the triangle's second and third corner
};

class PartTracer {
 public:
  // Copies the triangles. Throws Error{failed} when Embree reports an error.
  explicit PartTracer(const std::vector<ScenePart>& parts);
  ~PartTracer();
  PartTracer(PartTracer&&) noexcept;
  PartTracer& operator=(PartTracer&&) noexcept;

  // Both may be called from many threads at once.
  void closest(const RayPack& rays, std::array<PartHit, RayPack::size>& hits) const;
  std::array<bool, RayPack::size> blocked(const RayPack& rays, float max_distance) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Interpolated over the triangle of a hit.
template <class T>
T at_hit(const std::vector<T>& values, const ScenePart& part, const PartHit& hit) {
  const auto& [i, j, k] = part.triangles[hit.triangle];
  return values[i] * (1 - hit.b - hit.c) + values[j] * hit.b + values[k] * hit.c;
}

}  // namespace bole::sim
