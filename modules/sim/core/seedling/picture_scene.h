// All that a picture of a seedling shows: what stands on the mat (world axes), the room around it (room axes; they are
// the world axes unless a turntable turns), and the light.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "base/transform.h"
#include "sim/core/seedling/part_tracer.h"
#include "sim/core/seedling/scene_part.h"

namespace bole::sim {

// Soft lamps and a bright ceiling, in room axes.
class Lighting {
 public:
  struct Lamp {
    Eigen::Vector3f direction;  // towards it
    float sharpness = 1, strength = 1;
  };

  explicit Lighting(std::uint64_t seed);

  // Radiance from a direction; a level plane that sees all of it has an irradiance of 1.
  float radiance(const Eigen::Vector3f& direction) const;
  // Highlight of a rough surface, seen from `to_camera`.
  float highlight(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_camera) const;

 private:
  std::vector<Lamp> lamps_;
  float ceiling_ = 0.5F, bounce_ = 0.25F, scale_ = 1;
};

struct PictureScene {
  std::vector<ScenePart> world, room;
  std::optional<PartTracer> world_rays, room_rays;  // of the parts above
  Pose T_room_world = Pose::Identity();

  void trace_again();  // after parts have moved
};

// Sets `light` and `through` of the parts in `world` (and of those in `room`, with `of_room`), from `samples`
// directions for each vertex (a multiple of 8). The same at any thread count.
void light_scene(PictureScene& scene, const Lighting& lighting, int samples, bool of_room, std::uint64_t seed,
                 const std::stop_token& cancel = {});

}  // namespace bole::sim
