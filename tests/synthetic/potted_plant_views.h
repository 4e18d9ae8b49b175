// Pictures of a potted plant: the neighbourhood of its stem traced with many rays per pixel, blurred by a known point
// spread in light, and stored as sRGB codes. The rest of each picture is plain.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>

#include "synthetic/potted_plant.h"

namespace bole::tests {

struct PictureSettings {
  int views = 24;
  int width = 1280, height = 720;
  double focal = 920;
  double distance = 0.45, rise = 0.25;  // of the camera from the stem, level and above the soil
  double sigma = 0.8;                   // point spread, pixels
  double noise = 1.5;                   // codes
  double pose_noise = 0.0003;           // metres, of the given poses
  bool srgb = true;                     // false: codes are light
  std::array<double, 5> distortion{};
  double top = 0.055;  // of the stem that is traced, above the soil
  std::uint64_t seed = 1;
};

class PottedPlantViews : public ViewSource {
 public:
  PottedPlantViews(const PottedPlant& plant, const PictureSettings& settings)
      : plant_(plant),
        s_(settings),
        made_(static_cast<std::size_t>(settings.views)),
        pictures_(static_cast<std::size_t>(settings.views)) {
    camera_.color = {s_.width, s_.height, s_.focal, s_.focal, s_.width / 2.0 - 3, s_.height / 2.0 + 5, s_.distortion};
    Random random(s_.seed, 9);
    for (int i = 0; i < s_.views; ++i) {
      const double turn = 2 * std::numbers::pi * i / s_.views;
      const double up = s_.rise * (0.6 + 0.8 * random.uniform());
      const Eigen::Vector3d eye =
          plant_.foot + Eigen::Vector3d(s_.distance * std::cos(turn), s_.distance * std::sin(turn), up);
      const Eigen::Vector3d ahead = (plant_.foot + Eigen::Vector3d(0, 0, 0.1) - eye).normalized();
      const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
      Pose pose = Pose::Identity();
      pose.linear().col(0) = right;
      pose.linear().col(1) = ahead.cross(right);
      pose.linear().col(2) = ahead;
      pose.translation() = eye;
      true_.push_back(pose);
      pose.translation() += s_.pose_noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      given_.poses.push_back({i / 30.0, pose});
    }
    given_.facts["world_axes"] = "board";
  }

  std::size_t size() const override { return true_.size(); }
  double time_s(std::size_t i) const override { return given_.poses[i].time_s; }
  std::string name(std::size_t i) const override { return std::to_string(i) + ".png"; }
  const RgbdCamera& camera(std::size_t) const override { return camera_; }
  bool has_depth() const override { return false; }
  const Trajectory& given_poses() const override { return given_; }
  std::string description() const override { return "potted plant"; }
  std::string locator() const override { return "{}"; }
  // A picture is traced once; it takes some tenths of a second.
  void read(std::size_t i, View& view, ViewParts) const override {
    // Isolated, so that a thread that waits here takes no other view, which might wait for this one.
    std::call_once(made_[i], [&] { tbb::this_task_arena::isolate([&] { pictures_[i] = picture(i); }); });
    view.color = pictures_[i];
  }

 private:
  struct Ray {
    Eigen::Vector3d o, d;
  };

  // Light from a direction and from the sky.
  static double shade(const Eigen::Vector3d& n) {
    return 0.35 + 0.25 * std::max(0.0, n.z()) +
           0.5 * std::max(0.0, n.dot(Eigen::Vector3d(0.5, -0.3, 0.8).normalized()));
  }

  std::optional<std::pair<double, Eigen::Vector3d>> on_stem(const Ray& ray) const {
    double z = 0.03;
    std::optional<std::pair<double, Eigen::Vector3d>> hit;
    for (int round = 0; round < 8; ++round) {
      const Eigen::Vector3d a = plant_.axis(z), t = plant_.tangent(z);
      const double r = plant_.diameter(z) / 2;
      const Eigen::Vector3d o = ray.o - a, d = ray.d - ray.d.dot(t) * t, w = o - o.dot(t) * t;
      const double qa = d.squaredNorm(), qb = d.dot(w), qc = w.squaredNorm() - r * r;
      const double root = qb * qb - qa * qc;
      const double at = root > 0 ? (-qb - std::sqrt(root)) / qa : -qb / qa;
      const Eigen::Vector3d p = ray.o + at * ray.d;
      z += (p - a).dot(t) * t.z();
      hit.reset();
      if (root > 0) hit.emplace(at, (w + at * d).normalized());
      if (z < -0.02 || z > plant_.stem_length) return std::nullopt;
    }
    if (z < 0) return std::nullopt;
    return hit;
  }

  Eigen::Vector3d light(const Ray& ray) const {
    double best = 1e9;
    Eigen::Vector3d color(0.55, 0.56, 0.58);
    const auto take = [&](double t, const Eigen::Vector3d& c) {
      if (t > 1e-6 && t < best) {
        best = t;
        color = c;
      }
    };
    if (const double t = -ray.o.z() / ray.d.z(); t > 0) {  // mat of squares
      const Eigen::Vector3d p = ray.o + t * ray.d;
      const bool on = p.x() > 0 && p.y() > -0.015 && p.x() < 0.3 && p.y() < 0.255;
      const bool black =
          (static_cast<int>(std::floor(p.x() / 0.03)) + static_cast<int>(std::floor(p.y() / 0.03))) % 2 == 0;
      take(t, Eigen::Vector3d::Constant(!on ? 0.3 : black ? 0.03 : 0.8));
    }
    const double soil_t = (plant_.foot.z() - ray.o.z() + plant_.soil_slope * (ray.o.x() - plant_.foot.x())) /
                          (ray.d.z() - plant_.soil_slope * ray.d.x());
    if (soil_t > 0) {
      const Eigen::Vector3d p = ray.o + soil_t * ray.d;
      if ((p.head<2>() - plant_.pot).norm() < plant_.rim_radius - 0.002) {
        const double grain =
            0.06 + 0.05 * std::sin(p.x() * 2100) * std::sin(p.y() * 1900) + 0.02 * std::sin(p.x() * 6000);
        take(soil_t, Eigen::Vector3d(1.2, 1, 0.8) * grain);
      }
    }
    for (const double r : {plant_.rim_radius, plant_.rim_radius - 0.002}) {  // wall, outside and inside
      const Eigen::Vector2d o = ray.o.head<2>() - plant_.pot, d = ray.d.head<2>();
      const double qa = d.squaredNorm(), qb = o.dot(d), qc = o.squaredNorm() - r * r, root = qb * qb - qa * qc;
      if (root <= 0) continue;
      for (const double s : {-1.0, 1.0}) {
        const double t = (-qb + s * std::sqrt(root)) / qa;
        const double z = ray.o.z() + t * ray.d.z();
        if (z > 0 && z < plant_.rim_height) take(t, Eigen::Vector3d(0.25, 0.12, 0.08));
      }
    }
    if (const auto hit = on_stem(ray)) take(hit->first, shade(hit->second) * Eigen::Vector3d(0.25, 0.32, 0.10));
    // Two leaves that hang before the stem in some views.
    for (const double turn : {0.4, 3.3}) {
      const Eigen::Vector3d c = plant_.foot + Eigen::Vector3d(0.04 * std::cos(turn), 0.04 * std::sin(turn), 0.035);
      const Eigen::Vector3d n = Eigen::Vector3d(std::cos(turn), std::sin(turn), 0.5).normalized();
      const double t = n.dot(c - ray.o) / n.dot(ray.d);
      const Eigen::Vector3d q = ray.o + t * ray.d - c;
      if (q.norm() < 0.014) take(t, shade(n.z() > 0 ? n : Eigen::Vector3d(-n)) * Eigen::Vector3d(0.10, 0.28, 0.05));
    }
    return color;
  }

  ColorImage picture(std::size_t index) const {
    ColorImage image(s_.width, s_.height, 3, 128);
    const Pose& pose = true_[index];
    const auto& camera = camera_.color;
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (double z = 0.008; z <= s_.top; z += 0.002) {
      const auto at = camera.project(pose.inverse() * plant_.axis(z));
      low = low.cwiseMin(*at);
      high = high.cwiseMax(*at);
    }
    constexpr int border = 26, fine = 4;
    const int x0 = std::max(0, static_cast<int>(low.x()) - border), y0 = std::max(0, static_cast<int>(low.y()) - 8);
    const int x1 = std::min(s_.width - 1, static_cast<int>(high.x()) + border);
    const int y1 = std::min(s_.height - 1, static_cast<int>(high.y()) + 8);
    const int w = (x1 - x0 + 1) * fine, h = (y1 - y0 + 1) * fine;
    if (w <= 0 || h <= 0) return image;
    std::vector<Eigen::Vector3d> sharp(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    tbb::parallel_for(0, h, [&](int y) {
      for (int x = 0; x < w; ++x) {
        const Eigen::Vector2d pixel(x0 + (x + 0.5) / fine - 0.5, y0 + (y + 0.5) / fine - 0.5);
        const Ray ray{pose.translation(), pose.linear() * camera.direction(pixel).normalized()};
        sharp[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)] = light(ray);
      }
    });
    // The point spread, and then the area of a pixel.
    const double sigma = s_.sigma * fine;
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    std::vector<double> kernel;
    double total = 0;
    for (int k = -reach; k <= reach; ++k) total += kernel.emplace_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    const auto blurred = [&](const std::vector<Eigen::Vector3d>& in, bool along_x) {
      std::vector<Eigen::Vector3d> out(in.size());
      tbb::parallel_for(0, h, [&](int y) {
        for (int x = 0; x < w; ++x) {
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (int k = -reach; k <= reach; ++k) {
            const int xx = along_x ? std::clamp(x + k, 0, w - 1) : x, yy = along_x ? y : std::clamp(y + k, 0, h - 1);
            sum += kernel[static_cast<std::size_t>(k + reach)] *
                   in[static_cast<std::size_t>(yy) * static_cast<std::size_t>(w) + static_cast<std::size_t>(xx)];
          }
          out[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)] = sum / total;
        }
      });
      return out;
    };
    const auto soft = blurred(blurred(sharp, true), false);
    Random random(s_.seed, 10, index);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int j = 0; j < fine; ++j)
          for (int i = 0; i < fine; ++i)
            sum += soft[static_cast<std::size_t>((y - y0) * fine + j) * static_cast<std::size_t>(w) +
                        static_cast<std::size_t>((x - x0) * fine + i)];
        sum /= fine * fine;
        for (int c = 0; c < 3; ++c) {
          const double l = std::clamp(sum[c], 0.0, 1.0);
          const double code = !s_.srgb ? l : l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
          image.at(x, y, c) =
              static_cast<std::uint8_t>(std::clamp(std::lround(255 * code + s_.noise * random.normal()), 0L, 255L));
        }
      }
    return image;
  }

  PottedPlant plant_;
  PictureSettings s_;
  RgbdCamera camera_;
  std::vector<Pose> true_;
  Trajectory given_;
  mutable std::vector<std::once_flag> made_;
  mutable std::vector<ColorImage> pictures_;
};

}  // namespace bole::tests
