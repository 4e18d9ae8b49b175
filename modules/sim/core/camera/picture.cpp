#include "sim/core/camera/picture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/random.h"

namespace bole::sim {
namespace {

constexpr double dot_slack = 0.002;  // metres before a surface that do not shade it

float unit_float(std::uint64_t bits) { return static_cast<float>(static_cast<double>(bits & 0xffffffu) * 0x1.0p-24); }

class PicturePainter {
 public:
  PicturePainter(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                 const PixelDirections& pixels, const ViewPose& view, const PictureOptions& o, std::uint64_t seed)
      : scene_(scene), lighting_(lighting), colors_(colors), pixels_(pixels), view_(view), o_(o), seed_(seed) {}

  Image<float> paint() const {
    const auto& camera = pixels_.camera();
    const int n = o_.samples, channels = o_.infrared ? 1 : 3;
    cv::Mat fine(camera.height * n, camera.width * n, CV_32FC(channels), cv::Scalar::all(0));
    tbb::parallel_for(tbb::blocked_range<int>(0, fine.rows, 4), [&](const auto& rows) {
      for (int y = rows.begin(); y < rows.end() && !o_.cancel.stop_requested(); ++y)
        paint_row(y, fine.cols, fine.ptr<float>(y));
    });
    if (o_.point_spread > 0) cv::GaussianBlur(fine, fine, {0, 0}, o_.point_spread * n, 0, cv::BORDER_REPLICATE);
    Image<float> out(camera.width, camera.height, channels);
    cv::Mat coarse(camera.height, camera.width, CV_32FC(channels), out.values.data());
    cv::resize(fine, coarse, coarse.size(), 0, 0, cv::INTER_AREA);
    return out;
  }

 private:
  using Lanes = std::array<float, RayPack::size>;

  void paint_row(int y, int columns, float* row) const {
    const double per = 1.0 / o_.samples;
    SeenRays rays(scene_, view_);
    std::array<Eigen::Vector3d, RayPack::size> directions;
    for (int x = 0; x < columns; x += RayPack::size) {
      for (int k = 0; k < RayPack::size; ++k) {
        const auto bits = mix64(seed_ ^ (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x + k)));
        // Anywhere in its part of the pixel, at any moment of the exposure.
        const double px = (x + k + static_cast<double>(unit_float(bits))) * per - 0.5;
        const double py = (y + static_cast<double>(unit_float(bits >> 20))) * per - 0.5;
        directions[static_cast<std::size_t>(k)] = pixels_.at(px, py);
        rays.set(k, directions[static_cast<std::size_t>(k)], static_cast<double>(unit_float(bits >> 40)) - 0.5);
        if (x + k >= columns) rays.skip(k);
      }
      rays.look();
      Lanes dots{};
      if (o_.projector) dots = dot_light(rays, directions);
      for (int k = 0; k < RayPack::size && x + k < columns; ++k) {
        if (o_.infrared) {
          row[x + k] = infrared(rays, k, dots[static_cast<std::size_t>(k)]);
        } else {
          color(rays, k, row + 3 * (x + k));
        }
      }
    }
  }

  float footprint(const SeenPoint& seen) const {
    return 1.2F * seen.hit.distance / static_cast<float>(pixels_.camera().fx * o_.samples);
  }

  float infrared(const SeenRays& rays, int lane, float dots) const {
    const auto& seen = rays.seen(lane);
    if (!seen.part) return 0;
    const auto surface = colors_.at(*seen.part, at_hit(seen.part->uv, *seen.part, seen.hit), footprint(seen));
    const float light = at_hit(seen.part->light, *seen.part, seen.hit);
    return surface.infrared * (static_cast<float>(o_.room_light) * light + dots);
  }

  void color(const SeenRays& rays, int lane, float* out) const {
    const auto& seen = rays.seen(lane);
    if (!seen.part) {
      std::fill_n(out, 3, 0.4F);
      return;
    }
    const auto& part = *seen.part;
    const auto surface = colors_.at(part, at_hit(part.uv, part, seen.hit), footprint(seen));
    const float light = at_hit(part.light, part, seen.hit);
    Eigen::Array3f rgb = surface.rgb * light;
    if (part.surface == PartSurface::leaf) rgb += surface.through * at_hit(part.through, part, seen.hit);
    if (surface.gloss > 0) {
      const Eigen::Vector3f normal =
          rays.room_of_part(lane).linear().cast<float>() * at_hit(part.normals, part, seen.hit).normalized();
      rgb += surface.gloss * std::min(1.0F, light) * lighting_.highlight(normal, rays.to_camera(lane));
    }
    for (int c = 0; c < 3; ++c) out[c] = rgb[c];
  }

  // Light of the projector on what the rays met. All points are in camera axes, then in those of the world, where the
  // plant may stand in the way.
  Lanes dot_light(const SeenRays& rays, const std::array<Eigen::Vector3d, RayPack::size>& directions) const {
    RayPack shadow;
    Lanes light{};
    const Eigen::Vector3d lamp = view_.T_world_camera * o_.projector->offset;
    for (int k = 0; k < RayPack::size; ++k) {
      const auto& seen = rays.seen(k);
      const auto i = static_cast<std::size_t>(k);
      const Eigen::Vector3d at = seen.part ? Eigen::Vector3d(directions[i] * static_cast<double>(seen.hit.distance))
                                           : Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d way = at - o_.projector->offset;
      shadow.active[i] = seen.part != nullptr;
      shadow.set(k, lamp, view_.T_world_camera.linear() * way * std::max(0.0, 1 - dot_slack / way.norm()));
      if (seen.part) light[i] = o_.projector->light(way) * std::abs(rays.facet_normal(k).dot(rays.to_camera(k)));
    }
    const auto dark = scene_.world_rays->blocked(shadow, 1);
    for (std::size_t i = 0; i < light.size(); ++i)
      if (dark[i]) light[i] = 0;
    return light;
  }

  const PictureScene& scene_;
  const Lighting& lighting_;
  const SurfaceColors& colors_;
  const PixelDirections& pixels_;
  const ViewPose& view_;
  const PictureOptions& o_;
  std::uint64_t seed_;
};

}  // namespace

// One dot in each cell of a grid over the tangents of the angles, at a random place that keeps it within its cell.
float DotProjector::light(const Eigen::Vector3d& point) const {
  if (point.z() <= 0) return 0;
  const Eigen::Vector2d at = point.head<2>() / (point.z() * cell);
  const double i = std::floor(at.x()), k = std::floor(at.y());
  const auto key = static_cast<std::uint64_t>(static_cast<std::int64_t>(i)) * 0x9E3779B97F4A7C15ull +
                   static_cast<std::uint64_t>(static_cast<std::int64_t>(k));
  const auto bits = mix64(seed ^ mix64(key));
  const double margin = std::min(0.5, 2 * spread / cell);
  const double u = i + margin + (1 - 2 * margin) * static_cast<double>(unit_float(bits));
  const double v = k + margin + (1 - 2 * margin) * static_cast<double>(unit_float(bits >> 24));
  const double off = (Eigen::Vector2d(u, v) - at).squaredNorm() * cell * cell;
  const double near = 0.5 / point.norm();
  const double own = 0.6 + 0.8 * static_cast<double>(unit_float(bits >> 40));
  return static_cast<float>(strength * own * near * near * std::exp(-0.5 * off / (spread * spread)));
}

Image<float> render_picture(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                            const PixelDirections& pixels, const ViewPose& view, const PictureOptions& options,
                            std::uint64_t seed) {
  return PicturePainter(scene, lighting, colors, pixels, view, options, seed).paint();
}

}  // namespace bole::sim
