#include "sim/core/seedling/picture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

float unit_float(std::uint64_t bits) { return static_cast<float>(static_cast<double>(bits & 0xffffffu) * 0x1.0p-24); }

// A ray of the camera at a moment of the exposure, -0.5 to 0.5.
void set_ray(RayPack& pack, int lane, const Pose& T_target_camera, const Vector6d& motion,
             const Eigen::Vector3d& direction, double moment) {
  const Eigen::Vector3d turned = direction + moment * motion.head<3>().cross(direction);
  pack.set(lane, T_target_camera * Eigen::Vector3d(moment * motion.tail<3>()), T_target_camera.linear() * turned);
}

struct SeenPoint {
  const ScenePart* part = nullptr;
  PartHit hit;
  bool in_world = false;
};

// What eight rays meet: the plant's side of the scene first, the room where it meets nothing.
void see(const PictureScene& scene, RayPack& in_world, RayPack& in_room, std::array<SeenPoint, RayPack::size>& seen) {
  std::array<PartHit, RayPack::size> hits;
  scene.world_rays->closest(in_world, hits);
  bool more = false;
  for (std::size_t k = 0; k < RayPack::size; ++k) {
    seen[k] = {};
    in_room.active[k] = in_world.active[k] && hits[k].part < 0;
    more = more || in_room.active[k];
    if (hits[k].part >= 0) seen[k] = {&scene.world[static_cast<std::size_t>(hits[k].part)], hits[k], true};
  }
  if (!more) return;
  scene.room_rays->closest(in_room, hits);
  for (std::size_t k = 0; k < RayPack::size; ++k)
    if (in_room.active[k] && hits[k].part >= 0)
      seen[k] = {&scene.room[static_cast<std::size_t>(hits[k].part)], hits[k], false};
}

class PicturePainter {
 public:
  PicturePainter(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                 const PixelDirections& pixels, const ViewPose& view, const PictureOptions& o, std::uint64_t seed)
      : scene_(scene), lighting_(lighting), colors_(colors), pixels_(pixels), view_(view), o_(o), seed_(seed) {}

  Image<float> paint() const {
    const auto& camera = pixels_.camera();
    const int n = o_.samples, channels = o_.infrared ? 1 : 3;
    cv::Mat fine(camera.height * n, camera.width * n, CV_32FC(channels));
    tbb::parallel_for(tbb::blocked_range<int>(0, fine.rows, 4), [&](const auto& rows) {
      for (int y = rows.begin(); y < rows.end(); ++y) paint_row(y, fine.cols, fine.ptr<float>(y));
    });
    if (o_.point_spread > 0) cv::GaussianBlur(fine, fine, {0, 0}, o_.point_spread * n, 0, cv::BORDER_REPLICATE);
    Image<float> out(camera.width, camera.height, channels);
    cv::Mat coarse(camera.height, camera.width, CV_32FC(channels), out.values.data());
    cv::resize(fine, coarse, coarse.size(), 0, 0, cv::INTER_AREA);
    return out;
  }

 private:
  void paint_row(int y, int columns, float* row) const {
    const double per = 1.0 / o_.samples;
    for (int x = 0; x < columns; x += RayPack::size) {
      RayPack in_world, in_room;
      for (int k = 0; k < RayPack::size; ++k) {
        const auto bits = mix64(seed_ ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x + k)));
        in_world.active[static_cast<std::size_t>(k)] = x + k < columns;
        // Anywhere in its part of the pixel, at any moment of the exposure.
        const double px = (x + k + static_cast<double>(unit_float(bits))) * per - 0.5;
        const double py = (y + static_cast<double>(unit_float(bits >> 20))) * per - 0.5;
        const double moment = static_cast<double>(unit_float(bits >> 40)) - 0.5;
        const Eigen::Vector3d d = pixels_.at(px, py);
        set_ray(in_world, k, view_.T_world_camera, view_.world_motion, d, moment);
        set_ray(in_room, k, view_.T_room_camera, view_.room_motion, d, moment);
      }
      std::array<SeenPoint, RayPack::size> seen;
      see(scene_, in_world, in_room, seen);
      for (int k = 0; k < RayPack::size && x + k < columns; ++k)
        shade(seen[static_cast<std::size_t>(k)], in_world, in_room, k, row + (x + k) * (o_.infrared ? 1 : 3));
    }
  }

  void shade(const SeenPoint& seen, const RayPack& in_world, const RayPack& in_room, int lane, float* out) const {
    if (!seen.part) {
      std::fill_n(out, o_.infrared ? 1 : 3, 0.4F);
      return;
    }
    const auto& part = *seen.part;
    const float foot = 1.2F * seen.hit.distance / static_cast<float>(pixels_.camera().fx * o_.samples);
    const auto color = colors_.at(part, at_hit(part.uv, part, seen.hit), foot);
    const float light = at_hit(part.light, part, seen.hit);
    if (o_.infrared) {
      *out = color.infrared * light;
      return;
    }
    Eigen::Array3f rgb = color.rgb * light;
    if (part.surface == PartSurface::leaf) rgb += color.through * at_hit(part.through, part, seen.hit);
    if (color.gloss > 0) {
      const RayPack& rays = seen.in_world ? in_world : in_room;
      const Pose& T = seen.in_world ? scene_.T_room_world : identity_;
      const Eigen::Vector3d back(-static_cast<double>(rays.direction[0][lane]),
                                 -static_cast<double>(rays.direction[1][lane]),
                                 -static_cast<double>(rays.direction[2][lane]));
      const Eigen::Vector3f to_camera = (T.linear() * back).normalized().cast<float>();
      const Eigen::Vector3d normal = at_hit(part.normals, part, seen.hit).normalized().cast<double>();
      rgb += color.gloss * std::min(1.0F, light) * lighting_.highlight((T.linear() * normal).cast<float>(), to_camera);
    }
    for (int c = 0; c < 3; ++c) out[c] = rgb[c];
  }

  const PictureScene& scene_;
  const Lighting& lighting_;
  const SurfaceColors& colors_;
  const PixelDirections& pixels_;
  const ViewPose& view_;
  const PictureOptions& o_;
  std::uint64_t seed_;
  Pose identity_ = Pose::Identity();
};

float srgb_of_linear(float v) { return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F; }

}  // namespace

PixelDirections::PixelDirections(const CameraModel& camera) : camera_(camera) {
  if (!camera.distorted()) return;
  for (int y = 0; y <= camera.height; ++y)
    for (int x = 0; x <= camera.width; ++x)
      corners_.push_back(camera.direction({x - 0.5, y - 0.5}).head<2>().cast<float>());
}

Eigen::Vector3d PixelDirections::at(double x, double y) const {
  if (corners_.empty()) return {(x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1};
  const double u = std::clamp(x + 0.5, 0.0, camera_.width - 1e-9), v = std::clamp(y + 0.5, 0.0, camera_.height - 1e-9);
  const int i = static_cast<int>(u), k = static_cast<int>(v);
  const auto s = static_cast<float>(u - i), t = static_cast<float>(v - k);
  const auto at = [&](int a, int b) { return corners_[static_cast<std::size_t>(b * (camera_.width + 1) + a)]; };
  const Eigen::Vector2f d =
      (1 - t) * ((1 - s) * at(i, k) + s * at(i + 1, k)) + t * ((1 - s) * at(i, k + 1) + s * at(i + 1, k + 1));
  return d.cast<double>().homogeneous();
}

Image<float> render_picture(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                            const PixelDirections& pixels, const ViewPose& view, const PictureOptions& options,
                            std::uint64_t seed) {
  return PicturePainter(scene, lighting, colors, pixels, view, options, seed).paint();
}

ColorImage develop(const Image<float>& light, double exposure, const SensorNoise& noise, std::uint64_t seed) {
  // The curve is flat enough between 4096 steps for 8 bits.
  constexpr int steps = 4096;
  static const std::vector<float> curve = [] {
    std::vector<float> c;
    for (int i = 0; i <= steps; ++i) c.push_back(255 * srgb_of_linear(static_cast<float>(i) / steps));
    return c;
  }();
  ColorImage out(light.width, light.height, 3);
  const auto factor = static_cast<float>(exposure), shot = static_cast<float>(noise.shot),
             read = static_cast<float>(noise.read);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, light.values.size(), 1 << 14), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const float value = factor * light.values[i];
      const float sd = std::sqrt(shot * shot * std::max(0.0F, value) + read * read);
      const float noisy = std::clamp(value + sd * quick_normal(mix64(seed ^ mix64(i))), 0.0F, 1.0F) * steps;
      const int k = std::min(static_cast<int>(noisy), steps - 1);
      const float s = noisy - static_cast<float>(k);
      out.values[i] = static_cast<std::uint8_t>(
          std::lround((1 - s) * curve[static_cast<std::size_t>(k)] + s * curve[static_cast<std::size_t>(k) + 1]));
    }
  });
  return out;
}

ExactDepth render_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view,
                        const std::vector<Eigen::Vector2f>& shifts) {
  const auto& camera = pixels.camera();
  ExactDepth out{DepthImage(camera.width, camera.height), Image<float>(camera.width, camera.height)};
  tbb::parallel_for(tbb::blocked_range<int>(0, camera.height, 4), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < camera.width; x += RayPack::size) {
        RayPack in_world, in_room;
        for (int k = 0; k < RayPack::size; ++k) {
          const int px = std::min(x + k, camera.width - 1);
          in_world.active[static_cast<std::size_t>(k)] = x + k < camera.width;
          Eigen::Vector2d at(px, y);
          if (!shifts.empty()) at += shifts[out.depth.index(px, y)].cast<double>();
          const Eigen::Vector3d d = pixels.at(at.x(), at.y());
          set_ray(in_world, k, view.T_world_camera, Vector6d::Zero(), d, 0);
          set_ray(in_room, k, view.T_room_camera, Vector6d::Zero(), d, 0);
        }
        std::array<SeenPoint, RayPack::size> seen;
        see(scene, in_world, in_room, seen);
        for (int k = 0; k < RayPack::size && x + k < camera.width; ++k) {
          const auto& s = seen[static_cast<std::size_t>(k)];
          if (!s.part) continue;
          const RayPack& rays = s.in_world ? in_world : in_room;
          const Eigen::Vector3f d(rays.direction[0][k], rays.direction[1][k], rays.direction[2][k]);
          out.depth.at(x + k, y) = s.hit.distance;  // directions have z = 1 in the camera
          const auto& [a, b, c] = s.part->triangles[s.hit.triangle];
          const auto& p = s.part->positions;
          const Eigen::Vector3f normal = (p[b] - p[a]).cross(p[c] - p[a]).normalized();
          out.cosine.at(x + k, y) = std::abs(normal.dot(d.normalized()));
        }
      }
  });
  return out;
}

}  // namespace bole::sim
