#include "render/scene/eye_dome.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bole::render {
namespace {

struct Offset {
  int dx, dy;
};

std::array<Offset, 16> offsets(double radius_px) {
  std::array<Offset, 16> list{};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % 8) / 8,
                 radius = i < 8 ? radius_px : 2.5 * radius_px;
    list[i] = {static_cast<int>(std::lround(radius * std::cos(angle))),
               static_cast<int>(std::lround(radius * std::sin(angle)))};
  }
  return list;
}

// Calls put(at, light) for every pixel that was drawn.
template <class Put>
void light_pixels(const std::vector<float>& depth_m, int width, int height, const EyeDomeOptions& options, Put put) {
  const auto around = offsets(options.radius_px);
  const auto per_metre = static_cast<float>(1 / options.full_depth_m);
  const auto strength = static_cast<float>(options.strength);
  const auto index = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = index(x, y);
        const float depth = depth_m[at];
        if (!std::isfinite(depth)) continue;
        float hollow = 0;
        for (const auto& o : around) {
          const int nx = std::clamp(x + o.dx, 0, width - 1), ny = std::clamp(y + o.dy, 0, height - 1);
          hollow += std::clamp((depth - depth_m[index(nx, ny)]) * per_metre, 0.0F, 1.0F);
        }
        put(at, 1 - strength * std::min(1.0F, 1.3F * hollow / static_cast<float>(around.size())));
      }
  });
}

}  // namespace

void shade_eye_dome(std::span<std::uint8_t> rgb, const std::vector<float>& depth_m, int width, int height,
                    const EyeDomeOptions& options) {
  light_pixels(depth_m, width, height, options, [&](std::size_t at, float light) {
    for (std::size_t c = 0; c < 3; ++c)
      rgb[3 * at + c] = static_cast<std::uint8_t>(std::lround(static_cast<float>(rgb[3 * at + c]) * light));
  });
}

std::vector<std::uint8_t> eye_dome_shadow(const std::vector<float>& depth_m, int width, int height,
                                          const EyeDomeOptions& options) {
  std::vector<std::uint8_t> alpha(depth_m.size(), 0);
  light_pixels(depth_m, width, height, options, [&](std::size_t at, float light) {
    alpha[at] = static_cast<std::uint8_t>(std::lround(255 * (1 - light)));
  });
  return alpha;
}

std::vector<float> window_depths_m(vtkRenderWindow* window, vtkCamera* camera) {
  vtkNew<vtkFloatArray> buffer;
  window->GetZbufferData(0, 0, window->GetSize()[0] - 1, window->GetSize()[1] - 1, buffer);
  const auto* z = buffer->GetPointer(0);
  const auto n = static_cast<float>(camera->GetClippingRange()[0]),
             f = static_cast<float>(camera->GetClippingRange()[1]);
  const bool parallel = camera->GetParallelProjection() != 0;
  std::vector<float> depth(static_cast<std::size_t>(buffer->GetNumberOfValues()));
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth[i] = z[i] >= 1  ? std::numeric_limits<float>::infinity()
               : parallel ? n + z[i] * (f - n)
                          : n * f / (f - z[i] * (f - n));
  return depth;
}

}  // namespace bole::render
