#include "plant/core/mvs/patch_match.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"

namespace bole::plant {
namespace {

constexpr int max_samples = 121;

// A plane through a pixel's ray: depth there, and its normal in camera axes (towards the camera: z < 0).
struct Plane {
  float depth = 1;
  Eigen::Vector3f normal = -Eigen::Vector3f::UnitZ();
};

Eigen::Vector3f ray_of(const CameraModel& c, float x, float y) {
  return {(x - static_cast<float>(c.cx)) / static_cast<float>(c.fx),
          (y - static_cast<float>(c.cy)) / static_cast<float>(c.fy), 1};
}

Eigen::Matrix3f intrinsics(const CameraModel& c) {
  Eigen::Matrix3f k = Eigen::Matrix3f::Identity();
  k(0, 0) = static_cast<float>(c.fx), k(1, 1) = static_cast<float>(c.fy);
  k(0, 2) = static_cast<float>(c.cx), k(1, 2) = static_cast<float>(c.cy);
  return k;
}

class Matcher {
 public:
  Matcher(const GreyView& reference, const std::vector<const GreyView*>& neighbours, const PatchMatchSetting& setting)
      : reference_(reference), setting_(setting) {
    const Eigen::Matrix3f from = intrinsics(reference.camera).inverse();
    for (const auto* n : neighbours) {
      const Eigen::Isometry3f T = n->T_camera_local * reference.T_camera_local.inverse();
      const Eigen::Matrix3f k = intrinsics(n->camera);
      pairs_.push_back({n, k * T.linear() * from, k * T.translation()});
    }
  }

  // One minus the mean correlation with the best neighbours; 2 where fewer see the patch.
  float cost(int x, int y, const Plane& plane) const {
    const Eigen::Vector3f ray = ray_of(reference_.camera, static_cast<float>(x), static_cast<float>(y));
    const float distance = plane.normal.dot(ray) * plane.depth;  // of the plane from the camera, negative
    if (distance > -1e-6F) return 2;
    std::array<float, max_samples> own;
    std::array<Eigen::Vector2f, max_samples> offsets;
    int count = 0;
    float mean = 0;
    for (int v = -setting_.radius; v <= setting_.radius; ++v)
      for (int u = -setting_.radius; u <= setting_.radius; ++u) {
        const int px = x + u * setting_.step, py = y + v * setting_.step;
        if (!reference_.grey.contains(px, py)) continue;
        own[static_cast<std::size_t>(count)] = reference_.grey.at(px, py);
        mean += own[static_cast<std::size_t>(count)];
        offsets[static_cast<std::size_t>(count++)] = {static_cast<float>(px), static_cast<float>(py)};
      }
    mean /= static_cast<float>(count);
    float square = 0;
    for (int i = 0; i < count; ++i) {
      own[static_cast<std::size_t>(i)] -= mean;
      square += own[static_cast<std::size_t>(i)] * own[static_cast<std::size_t>(i)];
    }
    if (square < 1e-4F * static_cast<float>(count)) return 2;  // nothing to recognise
    // p / n.p = ray / n.ray: homography K' (R + t n^T / distance) K^-1, with n^T K^-1 as a row.
    const auto& c = reference_.camera;
    const Eigen::RowVector3f row(plane.normal.x() / static_cast<float>(c.fx),
                                 plane.normal.y() / static_cast<float>(c.fy),
                                 plane.normal.z() - plane.normal.x() * static_cast<float>(c.cx / c.fx) -
                                     plane.normal.y() * static_cast<float>(c.cy / c.fy));
    std::array<float, 16> costs;
    int seen = 0;
    for (const auto& pair : pairs_) {
      const Eigen::Matrix3f h = pair.turn + pair.shift * (row / distance);
      const float correlation = correlate(pair, h, own, offsets, count, square);
      if (correlation > -1.5F && seen < 16) costs[static_cast<std::size_t>(seen++)] = 1 - correlation;
    }
    if (seen < setting_.best) return 2;
    std::sort(costs.begin(), costs.begin() + seen);
    float sum = 0;
    for (int i = 0; i < setting_.best; ++i) sum += costs[static_cast<std::size_t>(i)];
    return sum / static_cast<float>(setting_.best);
  }

  Plane random_plane(int x, int y, Random& random) const {
    Plane p;
    // Even in disparity, as pixels are.
    const auto inverse = static_cast<float>(random.uniform(1 / setting_.max_depth, 1 / setting_.min_depth));
    p.depth = 1 / inverse;
    p.normal = facing(Eigen::Vector3f(static_cast<float>(random.normal()), static_cast<float>(random.normal()),
                                      -1.0F - static_cast<float>(std::abs(random.normal()))),
                      x, y);
    return p;
  }

  Plane changed(const Plane& plane, int x, int y, float amount, Random& random) const {
    Plane p = plane;
    const float range = 1 / setting_.min_depth - 1 / setting_.max_depth;
    const float inverse = 1 / plane.depth + amount * range * static_cast<float>(random.uniform(-1, 1));
    p.depth = std::clamp(1 / std::max(1e-3F, inverse), setting_.min_depth, setting_.max_depth);
    const Eigen::Vector3f turn(static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)),
                               static_cast<float>(random.uniform(-1, 1)));
    p.normal = facing(plane.normal + 2 * amount * turn, x, y);
    return p;
  }

  // The plane of a neighbour pixel, seen along this pixel's ray.
  Plane carried(const Plane& plane, int from_x, int from_y, int x, int y) const {
    const Eigen::Vector3f from = ray_of(reference_.camera, static_cast<float>(from_x), static_cast<float>(from_y));
    const Eigen::Vector3f to = ray_of(reference_.camera, static_cast<float>(x), static_cast<float>(y));
    Plane p = plane;
    p.depth = plane.depth * plane.normal.dot(from) / std::min(-1e-6F, plane.normal.dot(to));
    p.depth = std::clamp(p.depth, setting_.min_depth, setting_.max_depth);
    return p;
  }

 private:
  struct Pair {
    const GreyView* view;
    Eigen::Matrix3f turn;
    Eigen::Vector3f shift;
  };

  Eigen::Vector3f facing(Eigen::Vector3f normal, int x, int y) const {
    const Eigen::Vector3f ray = ray_of(reference_.camera, static_cast<float>(x), static_cast<float>(y)).normalized();
    normal.normalize();
    // At least 10 degrees: a patch seen edge-on shows nothing.
    const float along = normal.dot(ray);
    if (along > -0.17F) normal -= (along + 0.18F) * ray;
    return normal.normalized();
  }

  static float correlate(const Pair& pair, const Eigen::Matrix3f& h, const std::array<float, max_samples>& own,
                         const std::array<Eigen::Vector2f, max_samples>& offsets, int count, float square) {
    const auto& image = pair.view->grey;
    float sum = 0, sum_square = 0, product = 0;
    for (int i = 0; i < count; ++i) {
      const auto& o = offsets[static_cast<std::size_t>(i)];
      const float w = h(2, 0) * o.x() + h(2, 1) * o.y() + h(2, 2);
      if (w < 1e-6F) return -2;
      const float u = (h(0, 0) * o.x() + h(0, 1) * o.y() + h(0, 2)) / w,
                  v = (h(1, 0) * o.x() + h(1, 1) * o.y() + h(1, 2)) / w;
      if (!(u >= 0 && v >= 0 && u < static_cast<float>(image.width - 1) && v < static_cast<float>(image.height - 1)))
        return -2;
      const int x = static_cast<int>(u), y = static_cast<int>(v);
      const float fx = u - static_cast<float>(x), fy = v - static_cast<float>(y);
      const float* p = &image.values[image.index(x, y)];
      const float value =
          (p[0] * (1 - fx) + p[1] * fx) * (1 - fy) + (p[image.width] * (1 - fx) + p[image.width + 1] * fx) * fy;
      sum += value;
      sum_square += value * value;
      product += value * own[static_cast<std::size_t>(i)];
    }
    const float variance = sum_square - sum * sum / static_cast<float>(count);
    if (variance < 1e-4F * static_cast<float>(count)) return 0;
    return product / std::sqrt(variance * square);
  }

  const GreyView& reference_;
  const PatchMatchSetting& setting_;
  std::vector<Pair> pairs_;
};

}  // namespace

DepthImage match_patches(const GreyView& reference, const std::vector<const GreyView*>& neighbours,
                         const PatchMatchSetting& setting, const Run& run) {
  const Matcher matcher(reference, neighbours, setting);
  const int width = reference.camera.width;
  DepthImage depth(width, reference.camera.height);
  if (neighbours.size() < static_cast<std::size_t>(setting.best)) return depth;
  std::vector<Plane> planes(depth.values.size());
  std::vector<float> costs(depth.values.size(), 2);
  const auto at = [&](int x, int y) { return depth.index(x, y); };
  tbb::parallel_for(setting.y0, setting.y1, [&](int y) {
    if (run.cancelled()) return;
    for (int x = setting.x0; x < setting.x1; ++x) {
      Random random(setting.seed, at(x, y));
      planes[at(x, y)] = matcher.random_plane(x, y, random);
      costs[at(x, y)] = matcher.cost(x, y, planes[at(x, y)]);
    }
  });
  // Like the fields of a chess board: those of one colour only read those of the other, so rows can be done side by
  // side.
  for (int iteration = 0; iteration < setting.iterations; ++iteration)
    for (int color = 0; color < 2; ++color) {
      tbb::parallel_for(setting.y0, setting.y1, [&](int y) {
        if (run.cancelled()) return;
        for (int x = setting.x0; x < setting.x1; ++x) {
          if (((x + y) & 1) != color) continue;
          auto& best = planes[at(x, y)];
          float& cost = costs[at(x, y)];
          constexpr std::array<std::array<int, 2>, 8> steps{
              {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-5, 0}, {5, 0}, {0, -5}, {0, 5}}};
          for (const auto& s : steps) {
            const int nx = x + s[0], ny = y + s[1];
            if (nx < setting.x0 || ny < setting.y0 || nx >= setting.x1 || ny >= setting.y1) continue;
            const Plane p = matcher.carried(planes[at(nx, ny)], nx, ny, x, y);
            if (const float c = matcher.cost(x, y, p); c < cost) {
              cost = c;
              best = p;
            }
          }
          Random random(setting.seed + 1 + static_cast<std::uint64_t>(iteration), at(x, y));
          for (float amount = 0.2F; amount > 0.0005F; amount *= 0.25F) {
            const Plane p = matcher.changed(best, x, y, amount, random);
            if (const float c = matcher.cost(x, y, p); c < cost) {
              cost = c;
              best = p;
            }
          }
        }
      });
      run.check_cancel();
    }
  for (std::size_t i = 0; i < depth.values.size(); ++i)
    if (costs[i] <= setting.max_cost) depth.values[i] = planes[i].depth;
  return depth;
}

}  // namespace bole::plant
