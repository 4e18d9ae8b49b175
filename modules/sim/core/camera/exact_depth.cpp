#include "sim/core/camera/exact_depth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace bole::sim {

ExactDepth render_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view,
                        const std::vector<Eigen::Vector2f>& shifts, const SurfaceColors* colors) {
  const auto& camera = pixels.camera();
  ExactDepth out{DepthImage(camera.width, camera.height), Image<float>(camera.width, camera.height), {}};
  if (colors) out.reflected = Image<float>(camera.width, camera.height);
  tbb::parallel_for(tbb::blocked_range<int>(0, camera.height, 4), [&](const auto& rows) {
    SeenRays rays(scene, view);
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < camera.width; x += RayPack::size) {
        for (int k = 0; k < RayPack::size; ++k) {
          if (x + k >= camera.width) {
            rays.skip(k);
            continue;
          }
          Eigen::Vector2d at(x + k, y);
          if (!shifts.empty()) at += shifts[out.depth.index(x + k, y)].cast<double>();
          rays.set(k, pixels.at(at.x(), at.y()), 0);
        }
        rays.look();
        for (int k = 0; k < RayPack::size && x + k < camera.width; ++k) {
          const auto& seen = rays.seen(k);
          if (!seen.part) continue;
          out.depth.at(x + k, y) = seen.hit.distance;
          out.cosine.at(x + k, y) = std::abs(rays.facet_normal(k).dot(rays.to_camera(k)));
          if (!colors) continue;
          const float foot = seen.hit.distance / static_cast<float>(camera.fx);
          out.reflected.at(x + k, y) =
              colors->at(*seen.part, at_hit(seen.part->uv, *seen.part, seen.hit), foot).infrared;
        }
      }
  });
  return out;
}

}  // namespace bole::sim
