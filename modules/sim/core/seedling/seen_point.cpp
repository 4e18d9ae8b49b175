#include "sim/core/seedling/seen_point.h"

#include <Eigen/Geometry>

namespace bole::sim {
namespace {

void set_ray(RayPack& pack, int lane, const Pose& T_target_camera, const Vector6d& motion,
             const Eigen::Vector3d& direction, double moment) {
  const Eigen::Vector3d turned = direction + moment * motion.head<3>().cross(direction);
  pack.set(lane, T_target_camera * Eigen::Vector3d(moment * motion.tail<3>()), T_target_camera.linear() * turned);
}

}  // namespace

void SeenRays::set(int lane, const Eigen::Vector3d& direction, double moment) {
  in_world_.active[static_cast<std::size_t>(lane)] = true;
  set_ray(in_world_, lane, view_.T_world_camera, view_.world_motion, direction, moment);
  set_ray(in_room_, lane, view_.T_room_camera, view_.room_motion, direction, moment);
}

void SeenRays::skip(int lane) {
  set(lane, Eigen::Vector3d::UnitZ(), 0);
  in_world_.active[static_cast<std::size_t>(lane)] = false;
}

// The room lies behind the plant's side of the scene (room_parts()): it is looked at where that is not met.
void SeenRays::look() {
  std::array<PartHit, RayPack::size> hits;
  scene_.world_rays->closest(in_world_, hits);
  bool more = false;
  for (std::size_t k = 0; k < RayPack::size; ++k) {
    seen_[k] = {};
    in_room_.active[k] = in_world_.active[k] && hits[k].part < 0;
    more = more || in_room_.active[k];
    if (hits[k].part >= 0) seen_[k] = {&scene_.world[static_cast<std::size_t>(hits[k].part)], hits[k], true};
  }
  if (!more) return;
  scene_.room_rays->closest(in_room_, hits);
  for (std::size_t k = 0; k < RayPack::size; ++k)
    if (in_room_.active[k] && hits[k].part >= 0)
      seen_[k] = {&scene_.room[static_cast<std::size_t>(hits[k].part)], hits[k], false};
}

Eigen::Vector3d SeenRays::direction(int lane) const {
  const RayPack& rays = seen(lane).in_world ? in_world_ : in_room_;
  return Eigen::Vector3f(rays.direction[0][lane], rays.direction[1][lane], rays.direction[2][lane]).cast<double>();
}

const Pose& SeenRays::room_of_part(int lane) const {
  static const Pose same = Pose::Identity();
  return seen(lane).in_world ? scene_.T_room_world : same;
}

Eigen::Vector3f SeenRays::facet_normal(int lane) const {
  const auto& part = *seen(lane).part;
  const auto& [a, b, c] = part.triangles[seen(lane).hit.triangle];
  const auto& p = part.positions;
  const Eigen::Vector3f normal = (p[b] - p[a]).cross(p[c] - p[a]).normalized();
  return room_of_part(lane).linear().cast<float>() * normal;
}

Eigen::Vector3f SeenRays::to_camera(int lane) const {
  return -(room_of_part(lane).linear() * direction(lane)).normalized().cast<float>();
}

}  // namespace bole::sim
