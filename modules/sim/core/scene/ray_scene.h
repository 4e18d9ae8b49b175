// A scene that rays are cast into.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/core/scene/scene_model.h"

namespace bole::sim {

// Rays of one pulse: they lie close together, which is what makes eight at once cheap.
struct RayBundle {
  static constexpr int size = 8;
  float origin[3][size];
  float direction[3][size];  // unit
  float max_range_m = 200;
  double time_s = 0;  // of the pulse, since the start of the recording: trees sway
};

struct RayHit {
  float range_m = 0;        // 0: nothing hit
  float cos_incidence = 0;  // 0 to 1
  float reflectivity = 0;
  float bark_depth_m = 0;
  int tree_id = 0;
  Material material = Material::ground;
};

class Wind;

class RayScene {
 public:
  // Builds the acceleration structure; the model's triangles are copied. With `wind` its trees sway; it must outlive
  // the scene. Throws Error{failed} when Embree reports an error.
  explicit RayScene(const SceneModel& model, const Wind* wind = nullptr);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // May be called from many threads at once.
  void intersect(const RayBundle& rays, RayHit hits[RayBundle::size]) const;

  std::size_t triangles() const;  // as stored: those of archetypes once

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bole::sim
