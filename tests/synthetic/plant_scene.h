// A small world with exact colour and depth: a textured table, a pot, a stem, and leaves that are ellipsoids, seen by
// an RGB-D camera that goes around it. All views are made in memory.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/core/view_source.h"

namespace bole::synthetic {

struct SceneHit {
  double t = std::numeric_limits<double>::max();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(), color = Eigen::Vector3d::Zero();
};

// Shapes around the z axis: sphere-like leaves, upright cylinders, and the table z = 0 (0.4 m to each side).
struct PlantScene {
  struct Leaf {
    Eigen::Vector3d centre, radii, color;
  };
  struct Cylinder {
    Eigen::Vector2d centre;
    double low = 0, high = 0, radius = 0;
    Eigen::Vector3d color;
  };
  std::vector<Leaf> leaves{{{0.03, 0.01, 0.16}, {0.03, 0.02, 0.01}, {0.25, 0.6, 0.2}},
                           {{-0.03, 0.02, 0.13}, {0.025, 0.02, 0.008}, {0.3, 0.65, 0.2}},
                           {{0.0, -0.03, 0.145}, {0.02, 0.03, 0.01}, {0.2, 0.55, 0.25}}};
  std::vector<Cylinder> cylinders{{{0, 0}, 0, 0.06, 0.04, {0.6, 0.35, 0.25}},
                                  {{0, 0}, 0.06, 0.17, 0.003, {0.45, 0.35, 0.2}}};

  SceneHit cast(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const {
    SceneHit hit;
    for (const auto& leaf : leaves) {
      const Eigen::Vector3d p = (o - leaf.centre).cwiseQuotient(leaf.radii), q = d.cwiseQuotient(leaf.radii);
      const double a = q.squaredNorm(), b = p.dot(q), c = p.squaredNorm() - 1, root = b * b - a * c;
      if (root < 0) continue;
      const double t = (-b - std::sqrt(root)) / a;
      if (t <= 0 || t >= hit.t) continue;
      hit.t = t;
      hit.normal = (p + t * q).cwiseQuotient(leaf.radii).normalized();
      const Eigen::Vector3d at = o + t * d;
      hit.color = leaf.color * (1 + 0.3 * std::sin(700 * at.x()) * std::sin(600 * at.y()));
    }
    for (const auto& cylinder : cylinders) {
      const Eigen::Vector2d p = o.head<2>() - cylinder.centre, q = d.head<2>();
      const double a = q.squaredNorm(), b = p.dot(q), c = p.squaredNorm() - cylinder.radius * cylinder.radius;
      if (const double root = b * b - a * c; root >= 0 && a > 0) {
        const double t = (-b - std::sqrt(root)) / a, z = o.z() + t * d.z();
        if (t > 0 && t < hit.t && z > cylinder.low && z < cylinder.high) {
          hit.t = t;
          hit.normal << (p + t * q) / cylinder.radius, 0;
          hit.color = cylinder.color * (1 + 0.2 * std::sin(400 * z));
        }
      }
      if (d.z() != 0) {
        const double t = (cylinder.high - o.z()) / d.z();
        if (t > 0 && t < hit.t && (p + t * q).squaredNorm() < cylinder.radius * cylinder.radius) {
          hit.t = t;
          hit.normal = Eigen::Vector3d::UnitZ();
          hit.color = 0.6 * cylinder.color;
        }
      }
    }
    if (d.z() < 0) {
      const double t = -o.z() / d.z();
      const Eigen::Vector3d at = o + t * d;
      if (t < hit.t && std::abs(at.x()) < 0.4 && std::abs(at.y()) < 0.4) {
        hit.t = t;
        hit.normal = Eigen::Vector3d::UnitZ();
        const bool dark =
            (static_cast<int>(std::floor(at.x() / 0.03)) + static_cast<int>(std::floor(at.y() / 0.03))) % 2 != 0;
        hit.color = dark ? Eigen::Vector3d(0.15, 0.15, 0.2) : Eigen::Vector3d(0.85, 0.85, 0.8);
      }
    }
    return hit;
  }

  // Distance from a point to the nearest surface (leaves to first order: exact near the surface).
  double distance(const Eigen::Vector3d& p) const {
    double nearest = std::abs(p.x()) < 0.4 && std::abs(p.y()) < 0.4 ? std::abs(p.z()) : 1;
    for (const auto& leaf : leaves) {
      const Eigen::Vector3d q = (p - leaf.centre).cwiseQuotient(leaf.radii);
      const double value = q.norm();
      const double slope = q.cwiseQuotient(leaf.radii).norm() / std::max(1e-9, value);
      nearest = std::min(nearest, std::abs(value - 1) / std::max(1e-9, slope));
    }
    for (const auto& c : cylinders) {
      const double radial = (p.head<2>() - c.centre).norm() - c.radius;
      if (p.z() > c.low && p.z() < c.high) nearest = std::min(nearest, std::abs(radial));
      if (radial < 0) nearest = std::min(nearest, std::abs(p.z() - c.high));
    }
    return nearest;
  }
};

class PlantSceneViews : public ViewSource {
 public:
  struct Settings {
    int views = 24, width = 160, height = 120;
    double focal = 150, distance = 0.45;
    double depth_noise = 0;  // m at 0.5 m
    double exposure = 0;     // amplitude of a slow drift of the brightness
    bool depth = true;
    bool masks = false;             // of leaves, stem and pot
    bool own_depth_camera = false;  // 15 mm beside the colour camera, with another focal length
  };

  explicit PlantSceneViews(Settings settings, PlantScene scene = {}) : settings_(settings), scene_(std::move(scene)) {
    auto& c = camera_.color;
    c.width = settings.width, c.height = settings.height;
    c.fx = c.fy = settings.focal;
    c.cx = (settings.width - 1) / 2.0, c.cy = (settings.height - 1) / 2.0;
    if (settings.own_depth_camera) {
      camera_.depth = c;
      camera_.depth->fx = camera_.depth->fy = 0.8 * settings.focal;
      camera_.T_color_depth = Eigen::Translation3d(0.015, 0.002, 0) * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY());
    }
    for (int i = 0; i < settings.views; ++i) {
      // Two rings of different height.
      const double angle = 2 * std::numbers::pi * i / settings.views * 2, tilt = i * 2 < settings.views ? 0.45 : 0.85;
      const Eigen::Vector3d target(0, 0, 0.09);
      const Eigen::Vector3d at =
          target + settings.distance * Eigen::Vector3d(std::cos(angle) * std::cos(tilt),
                                                       std::sin(angle) * std::cos(tilt), std::sin(tilt));
      Pose T = Pose::Identity();
      const Eigen::Vector3d z = (target - at).normalized(), x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
      T.linear().col(0) = x, T.linear().col(1) = z.cross(x), T.linear().col(2) = z;
      T.translation() = at;
      poses_.poses.push_back({time_s(static_cast<std::size_t>(i)), T});
    }
  }

  std::size_t size() const override { return static_cast<std::size_t>(settings_.views); }
  double time_s(std::size_t i) const override { return static_cast<double>(i) / 30; }
  std::string name(std::size_t i) const override { return std::to_string(i); }
  const RgbdCamera& camera(std::size_t) const override { return camera_; }
  bool has_depth() const override { return settings_.depth; }
  const Trajectory& given_poses() const override { return poses_; }
  std::string description() const override { return "scene"; }
  std::string locator() const override { return "{}"; }
  const PlantScene& scene() const { return scene_; }

  void read(std::size_t i, View& view, ViewParts parts) const override {
    const Pose& T_world_camera = poses_.poses[i].T_target_sensor;
    view = {};
    if (parts.color) {
      view.color = ColorImage(settings_.width, settings_.height, 3);
      const double gain = 1 + settings_.exposure * std::sin(2 * std::numbers::pi * static_cast<double>(i) / 12);
      for (int y = 0; y < settings_.height; ++y)
        for (int x = 0; x < settings_.width; ++x) {
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (const double dy : {-0.25, 0.25})
            for (const double dx : {-0.25, 0.25}) sum += color_at(T_world_camera, camera_.color, {x + dx, y + dy}) / 4;
          for (int c = 0; c < 3; ++c)
            view.color.at(x, y, c) = static_cast<std::uint8_t>(std::lround(std::clamp(sum(c) * gain, 0.0, 1.0) * 255));
        }
    }
    if (parts.mask && settings_.masks) {
      view.mask = MaskImage(settings_.width, settings_.height, 1, 0);
      for (int y = 0; y < settings_.height; ++y)
        for (int x = 0; x < settings_.width; ++x) {
          const Eigen::Vector3d d = T_world_camera.linear() * camera_.color.direction({x, y});
          const auto hit = scene_.cast(T_world_camera.translation(), d);
          if (hit.t < 10 && T_world_camera.translation().z() + hit.t * d.z() > 1e-4) view.mask.at(x, y) = 255;
        }
    }
    if (parts.depth && settings_.depth) {
      const auto& camera = camera_.of_depth();
      const Pose T_world_depth = T_world_camera * camera_.T_color_depth;
      view.depth = DepthImage(camera.width, camera.height);
      Random random(7, i);
      for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
          const Eigen::Vector3d d = camera.direction({x, y});
          const auto hit = scene_.cast(T_world_depth.translation(), T_world_depth.linear() * d);
          const double noise =
              settings_.depth_noise > 0 ? random.normal() * settings_.depth_noise * 4 * hit.t * hit.t : 0;
          if (hit.t < 10) view.depth.at(x, y) = static_cast<float>(hit.t + noise);  // d has z = 1
        }
    }
  }

 private:
  Eigen::Vector3d color_at(const Pose& T, const CameraModel& camera, const Eigen::Vector2d& pixel) const {
    const Eigen::Vector3d d = T.linear() * camera.direction(pixel);
    const auto hit = scene_.cast(T.translation(), d);
    if (hit.t > 10) return Eigen::Vector3d(0.5, 0.6, 0.7) + 0.1 * Eigen::Vector3d::Ones() * d.normalized().x();
    return hit.color * (0.75 + 0.25 * hit.normal.dot(Eigen::Vector3d(0.3, 0.2, 0.93)));
  }

  Settings settings_;
  PlantScene scene_;
  RgbdCamera camera_;
  Trajectory poses_;
};

}  // namespace bole::synthetic
