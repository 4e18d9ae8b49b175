// What eight neighbouring rays of a camera meet.
#pragma once

#include <array>

#include "sim/core/seedling/picture_scene.h"

namespace bole::sim {

// Where the camera is in the middle of the exposure, and how it moves during it: twists (rotation rad, translation m,
// camera axes) over the whole exposure, against the plant and against the room.
struct ViewPose {
  Pose T_world_camera = Pose::Identity();
  Pose T_room_camera = Pose::Identity();
  Vector6d world_motion = Vector6d::Zero(), room_motion = Vector6d::Zero();

  // Of a second camera that is mounted on the first and takes its picture in a moment.
  ViewPose mounted(const Pose& T_camera_other) const {
    return {T_world_camera * T_camera_other, T_room_camera * T_camera_other, Vector6d::Zero(), Vector6d::Zero()};
  }
};

struct SeenPoint {
  const ScenePart* part = nullptr;  // null: nothing
  PartHit hit;
  bool in_world = false;
};

// The same eight rays in world axes and in room axes, and what they meet. `directions` have z = 1 in the camera, so
// that the distances of hits are depths; `moment` of the exposure is -0.5 to 0.5.
class SeenRays {
 public:
  SeenRays(const PictureScene& scene, const ViewPose& view) : scene_(scene), view_(view) {}

  void set(int lane, const Eigen::Vector3d& direction, double moment);
  void skip(int lane);
  void look();

  const SeenPoint& seen(int lane) const { return seen_[static_cast<std::size_t>(lane)]; }
  // In the axes of the part that was met.
  Eigen::Vector3d direction(int lane) const;
  // Unit normal of the triangle, in room axes, and the unit vector from the point towards the camera.
  Eigen::Vector3f facet_normal(int lane) const;
  Eigen::Vector3f to_camera(int lane) const;
  const Pose& room_of_part(int lane) const;  // T_room_part of the part that was met

 private:
  const PictureScene& scene_;
  const ViewPose& view_;
  RayPack in_world_, in_room_;
  std::array<SeenPoint, RayPack::size> seen_;
};

}  // namespace bole::sim
