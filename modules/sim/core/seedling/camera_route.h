// Where the camera is for each view of a seedling.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "camera/camera_model.h"
#include "sim/core/seedling/seen_point.h"

namespace bole::sim {

// orbit: rings around the plant; turntable: the plant turns before a still camera; handheld: an orbit with tremor.
enum class SeedlingRoute { orbit, turntable, handheld };
constexpr std::array<std::string_view, 3> choice_names(SeedlingRoute) { return {"orbit", "turntable", "handheld"}; }

struct RouteRequest {
  SeedlingRoute kind = SeedlingRoute::orbit;
  int views = 100;
  double distance = 0;                               // metres from the axis of the plant; 0: as the plant needs it
  double tremor = 1;                                 // factor on the tremor of a hand
  double exposure = 0;                               // exposure / time between views
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  // of the mat, world axes
  double top = 0.4;                                  // of the plant, metres above the mat
};

// Poses of the views and the turn of the table with each.
struct RouteView {
  ViewPose pose;
  Pose T_room_world = Pose::Identity();
};
std::vector<RouteView> camera_route(const RouteRequest& request, const CameraModel& camera, std::uint64_t seed);

}  // namespace bole::sim
