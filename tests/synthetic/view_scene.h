// A scene of textured boxes on a textured floor, with a board printed on it, seen by a camera with exact poses. Rays
// are cast through every pixel, so colour and depth are exact before noise is added.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/core/view_source.h"

namespace bole::synthetic {

inline double hashed(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  return Random(seed, static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)).uniform();
}

// Smooth noise of several sizes, 0 to 1; `cell` is the finest, metres.
inline double texture(std::uint64_t seed, double u, double v, double cell) {
  double sum = 0, weight = 0, w = 1;
  for (int octave = 0; octave < 4; ++octave, cell *= 2, w *= 1.2) {
    const double x = u / cell, y = v / cell;
    const auto ix = static_cast<std::int64_t>(std::floor(x)), iy = static_cast<std::int64_t>(std::floor(y));
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const double fx = smooth(x - static_cast<double>(ix)), fy = smooth(y - static_cast<double>(iy));
    const auto s = seed * 7 + static_cast<std::uint64_t>(octave);
    const double low = (1 - fx) * hashed(s, ix, iy) + fx * hashed(s, ix + 1, iy);
    const double high = (1 - fx) * hashed(s, ix, iy + 1) + fx * hashed(s, ix + 1, iy + 1);
    sum += w * ((1 - fy) * low + fy * high);
    weight += w;
  }
  return std::clamp(0.5 + 1.6 * (sum / weight - 0.5), 0.0, 1.0);
}

struct TexturedBox {
  Eigen::Vector3d centre, half;
  double turn_rad = 0;  // about z
  std::uint64_t seed = 1;
};

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  double brightness = 0;
};

struct ViewScene {
  std::vector<TexturedBox> boxes;
  double texture_cell = 0.003;
  double floor_half = 0.35;  // metres; beyond it the floor ends
  // Brightness of the print at a place of the floor (x, y), or below zero where there is none.
  std::function<double(double, double)> print;
  // Distance of a textured wall that stands still before the camera; 0: none.
  double wall = 0;

  Hit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    Hit best;
    if (direction.z() < 0) {
      const double t = -origin.z() / direction.z();
      const Eigen::Vector3d p = origin + t * direction;
      if (t > 0 && std::abs(p.x()) < floor_half && std::abs(p.y()) < floor_half) {
        const double printed = print ? print(p.x(), p.y()) : -1;
        best = {t, printed >= 0 ? printed : texture(99, p.x(), p.y(), texture_cell)};
      }
    }
    for (const auto& b : boxes) cast_box(b, origin, direction, best);
    return best;
  }

 private:
  void cast_box(const TexturedBox& b, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                Hit& best) const {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(-b.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d o = R * (origin - b.centre), d = R * direction;
    double near = -1e30, far = 1e30;
    int face = 0;
    for (int k = 0; k < 3; ++k) {
      double t0 = (-b.half[k] - o[k]) / d[k], t1 = (b.half[k] - o[k]) / d[k];
      if (t0 > t1) std::swap(t0, t1);
      if (t0 > near) {
        near = t0;
        face = k;
      }
      far = std::min(far, t1);
    }
    if (!(near < far) || !(near > 0) || !(near < best.t)) return;
    const Eigen::Vector3d p = o + near * d;
    const auto side = static_cast<std::uint64_t>(face * 2 + (p[face] > 0 ? 1 : 0));
    best = {near, texture(b.seed * 10 + side, p[(face + 1) % 3], p[(face + 2) % 3], texture_cell)};
  }
};

// Camera that looks from `eye` at `target`, x to the right, y down.
inline Pose look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  Pose T = Pose::Identity();
  const Eigen::Vector3d z = (target - eye).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  T.linear() << x, z.cross(x), z;
  T.translation() = eye;
  return T;
}

// Poses on a circle about the z axis.
inline std::vector<Pose> orbit(int count, double radius, double height, double target_height,
                               double full = 2 * std::numbers::pi) {
  std::vector<Pose> out;
  for (int i = 0; i < count; ++i) {
    const double a = full * i / count;
    out.push_back(look_at({radius * std::cos(a), radius * std::sin(a), height}, {0, 0, target_height}));
  }
  return out;
}

struct SceneCamera {
  RgbdCamera camera;
  double depth_noise = 0;   // standard deviation at 1 m, metres; grows with the square of the depth
  double depth_factor = 1;  // measured over true
  double image_noise = 0;   // of 255
  bool with_depth = true;
  double max_depth = 10;
  int samples = 2;  // across a pixel
};

class SceneViews : public ViewSource {
 public:
  SceneViews(ViewScene scene, SceneCamera camera, std::vector<Pose> T_world_camera)
      : scene_(std::move(scene)),
        camera_(std::move(camera)),
        poses_(std::move(T_world_camera)),
        drawn_(poses_.size()),
        views_(poses_.size()) {}

  std::optional<BoardFacts> board_facts;
  Trajectory given;
  std::vector<int> black;     // views that show nothing
  std::vector<int> no_depth;  // views whose depth is missing

  std::size_t size() const override { return poses_.size(); }
  double time_s(std::size_t i) const override { return static_cast<double>(i) / 30; }
  std::string name(std::size_t i) const override { return std::string(i < 10 ? "00000" : "0000") + std::to_string(i); }
  const RgbdCamera& camera(std::size_t) const override { return camera_.camera; }
  bool has_depth() const override { return camera_.with_depth; }
  const Trajectory& given_poses() const override { return given; }
  std::optional<BoardFacts> board() const override { return board_facts; }
  std::string description() const override { return "scene"; }
  std::string locator() const override { return "{}"; }
  const std::vector<Pose>& truth() const { return poses_; }

  void read(std::size_t index, View& view, ViewParts parts) const override {
    std::call_once(drawn_[index], [&] { draw_view(index, views_[index]); });
    const bool dark = std::ranges::count(black, static_cast<int>(index)) > 0;
    const bool blind = dark || std::ranges::count(no_depth, static_cast<int>(index)) > 0;
    const auto& made = views_[index];
    view = {};
    if (parts.color) view.color = dark ? ColorImage(made.color.width, made.color.height, 3) : made.color;
    if (!parts.depth || !camera_.with_depth) return;
    view.depth = blind ? DepthImage(made.depth.width, made.depth.height) : made.depth;
  }

 private:
  void draw_view(std::size_t index, View& view) const {
    const auto &c = camera_.camera.color, &d = camera_.camera.of_depth();
    view.color = ColorImage(c.width, c.height, 3);
    draw(index, view.color);
    if (!camera_.with_depth) return;
    view.depth = DepthImage(d.width, d.height);
    measure(index, view.depth);
  }

  Hit cast(const Pose& T_world_camera, const Pose& T_color_camera, const Eigen::Vector3d& direction) const {
    Hit hit = scene_.cast(T_world_camera.translation(), T_world_camera.linear() * direction);
    if (scene_.wall > 0) {
      const Eigen::Vector3d d = T_color_camera.linear() * direction, o = T_color_camera.translation();
      const double t = (scene_.wall - o.z()) / d.z();
      if (t < hit.t) {
        const Eigen::Vector3d p = o + t * d;
        hit = {t, texture(5, p.x(), p.y(), 2 * scene_.texture_cell)};
      }
    }
    return hit;
  }

  void draw(std::size_t index, ColorImage& image) const {
    const auto& c = camera_.camera.color;
    Random noise(11, index);
    const int n = camera_.samples;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        double sum = 0;
        for (int s = 0; s < n * n; ++s) {
          const Eigen::Vector2d pixel(x + (s % n + 0.5) / n - 0.5, y + (s / n + 0.5) / n - 0.5);
          const auto hit = cast(poses_[index], Pose::Identity(), c.direction(pixel));
          sum += std::isfinite(hit.t) ? hit.brightness : 0.5;
        }
        const double value =
            25 + 200 * sum / (n * n) + camera_.image_noise * (camera_.image_noise > 0 ? noise.normal() : 0);
        for (int k = 0; k < 3; ++k) image.at(x, y, k) = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
  }

  void measure(std::size_t index, DepthImage& image) const {
    const auto& d = camera_.camera.of_depth();
    const Pose T_world_depth = poses_[index] * camera_.camera.T_color_depth;
    Random noise(12, index);
    for (int y = 0; y < d.height; ++y)
      for (int x = 0; x < d.width; ++x) {
        const auto hit = cast(T_world_depth, camera_.camera.T_color_depth, d.direction(Eigen::Vector2d(x, y)));
        if (!(hit.t < camera_.max_depth)) continue;
        const double error = camera_.depth_noise > 0 ? camera_.depth_noise * hit.t * hit.t * noise.normal() : 0;
        image.at(x, y) = static_cast<float>(camera_.depth_factor * (hit.t + error));
      }
  }

  ViewScene scene_;
  SceneCamera camera_;
  std::vector<Pose> poses_;
  mutable std::vector<std::once_flag> drawn_;
  mutable std::vector<View> views_;
};

// Three boxes on the floor, the tallest in the middle.
inline ViewScene box_scene() {
  ViewScene scene;
  scene.boxes = {{{0, 0, 0.06}, {0.03, 0.04, 0.06}, 0.3, 1},
                 {{0.09, -0.05, 0.03}, {0.03, 0.02, 0.03}, 0.8, 2},
                 {{-0.08, 0.07, 0.02}, {0.025, 0.03, 0.02}, -0.5, 3}};
  return scene;
}

inline SceneCamera plain_camera(int width = 640, int height = 480, double focal = 560) {
  SceneCamera c;
  c.camera.color.width = width;
  c.camera.color.height = height;
  c.camera.color.fx = c.camera.color.fy = focal;
  c.camera.color.cx = (width - 1) / 2.0;
  c.camera.color.cy = (height - 1) / 2.0;
  return c;
}

}  // namespace bole::synthetic
