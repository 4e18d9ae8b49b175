#include "sim/core/seedling/camera_route.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

struct RouteWave {
  double size = 0, per_view = 0, phase = 0;
  double at(double t) const { return size * std::sin(two_pi * per_view * t + phase); }
};

Pose looking(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Pose T = Pose::Identity();
  const Eigen::Vector3d ahead = (to - from).normalized();
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
  T.linear() << right, ahead.cross(right), ahead;
  T.translation() = from;
  return T;
}

class RoutePlan {
 public:
  RoutePlan(const RouteRequest& r, const CameraModel& camera, std::uint64_t seed) : r_(r) {
    Random random(seed, Stream::camera_route);
    const double tan_half = 0.5 * camera.height / camera.fy;
    // What a view must show, and no nearer than a depth camera sees.
    const double needed = 1.12 * r.top;
    distance_ = r.distance > 0 ? r.distance : std::clamp(needed / (2 * tan_half), 0.36, 0.80);
    // What does not fit into one view is shown by looking up and down along the route.
    nod_ = 0.5 * std::clamp(needed - 2 * tan_half * distance_, 0.0, 0.6 * r.top);
    rings_ = r.kind == SeedlingRoute::turntable ? 1 : r.views >= 45 && r.kind == SeedlingRoute::orbit ? 3 : 2;
    start_ = random.angle();
    side_ = random.chance(0.5) ? 1 : -1;
    const std::array<double, 3> low{10, 28, 48}, high{17, 36, 58}, nearer{1, 0.97, 0.93}, look{0.5, 0.5, 0.52};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ring = r.kind == SeedlingRoute::turntable ? std::size_t{1} : k;
      elevation_[k] = random.uniform(low[ring], high[ring]) * rad_per_deg;
      nearer_[k] = nearer[ring];
      look_[k] = look[ring];
    }
    const bool hand = r.kind == SeedlingRoute::handheld;
    const double slow = r.kind == SeedlingRoute::turntable ? 0 : hand ? 2 : 1;
    const auto wave = [&](double size, double min_period, double max_period) {
      return RouteWave{size * random.uniform(0.5, 1), 1 / random.uniform(min_period, max_period), random.angle()};
    };
    wander_ = {wave(0.02 * slow, 20, 45),  wave(0.03 * slow, 20, 45),  wave(0.02 * slow, 15, 40),
               wave(0.012 * slow, 10, 30), wave(0.012 * slow, 10, 30), wave(0.012 * slow, 10, 30)};
    if (!hand) return;
    // Of a hand: rotations of a third of a degree, translations of 3 mm, from view to view.
    for (int axis = 0; axis < 6; ++axis)
      for (int k = 0; k < 3; ++k) {
        const int slower = 4 / (k + 1), faster = 8 / (k + 1);
        tremor_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)] =
            wave(r.tremor * (axis < 3 ? 0.3 * rad_per_deg : 0.003) / (k + 1), 2.2 + slower, 6 + faster);
      }
  }

  Pose T_room_camera(double t) const {
    if (r_.kind == SeedlingRoute::turntable) t = 0;
    const double per_ring = static_cast<double>(r_.views) / rings_;
    const double ring = std::clamp(t / per_ring, 0.0, rings_ - 1e-9);
    const auto k = static_cast<std::size_t>(ring);
    // The camera rises to the next ring in the last tenth of a ring.
    const double rise = std::clamp((ring - static_cast<double>(k) - 0.9) / 0.1, 0.0, 1.0);
    const double s = rise * rise * (3 - 2 * rise);
    const auto next = std::min(k + 1, static_cast<std::size_t>(rings_ - 1));
    const auto between = [&](const std::array<double, 3>& of) { return (1 - s) * of[k] + s * of[next]; };
    const double azimuth = start_ + side_ * (two_pi * t / per_ring + 0.3 * ring);
    const double elevation = between(elevation_) + wander_[1].at(t);
    const double distance = distance_ * between(nearer_) + wander_[0].at(t);
    const Eigen::Vector3d target(
        r_.middle.x() + wander_[3].at(t), r_.middle.y() + wander_[4].at(t),
        r_.top * between(look_) + wander_[5].at(t) + nod_ * std::sin(two_pi * 5.5 * t / r_.views));
    const Eigen::Vector3d out(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation));
    Pose T = looking(target + distance * out, target);
    if (r_.kind == SeedlingRoute::handheld) {
      Vector6d shake;
      for (int axis = 0; axis < 6; ++axis) {
        shake[axis] = 0;
        for (const auto& w : tremor_[static_cast<std::size_t>(axis)]) shake[axis] += w.at(t);
      }
      T = T * se3_exp(shake);
    }
    return T;
  }

  Pose T_room_world(double t) const {
    if (r_.kind != SeedlingRoute::turntable) return Pose::Identity();
    const Eigen::Translation3d middle(r_.middle.x(), r_.middle.y(), 0);
    return Pose(middle * Eigen::AngleAxisd(side_ * two_pi * t / r_.views, Eigen::Vector3d::UnitZ()) * middle.inverse());
  }

 private:
  RouteRequest r_;
  double distance_ = 0.5, start_ = 0, nod_ = 0;
  int rings_ = 1, side_ = 1;
  std::array<double, 3> elevation_{}, nearer_{}, look_{};
  std::array<RouteWave, 6> wander_{};
  std::array<std::array<RouteWave, 3>, 6> tremor_{};
};

}  // namespace

std::vector<RouteView> camera_route(const RouteRequest& request, const CameraModel& camera, std::uint64_t seed) {
  const RoutePlan plan(request, camera, seed);
  std::vector<RouteView> views;
  for (int i = 0; i < request.views; ++i) {
    const double before = i - 0.5 * request.exposure, after = i + 0.5 * request.exposure;
    const auto world_camera = [&](double t) { return Pose(plan.T_room_world(t).inverse() * plan.T_room_camera(t)); };
    RouteView view;
    view.T_room_world = plan.T_room_world(i);
    view.pose.T_room_camera = plan.T_room_camera(i);
    view.pose.T_world_camera = world_camera(i);
    if (request.exposure > 0) {
      view.pose.world_motion = se3_log(world_camera(before).inverse() * world_camera(after));
      view.pose.room_motion = se3_log(plan.T_room_camera(before).inverse() * plan.T_room_camera(after));
    }
    views.push_back(view);
  }
  return views;
}

}  // namespace bole::sim
