#include "render/scene/eye_dome.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bole {
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

}  // namespace

void shade_eye_dome(std::span<std::uint8_t> rgb, const std::vector<float>& depth_m, int width, int height,
                    const EyeDomeOptions& options) {
  const auto around = offsets(options.radius_px);
  const auto per_metre = static_cast<float>(1 / options.full_depth_m);
  const auto strength = static_cast<float>(options.strength);
  tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        const float depth = depth_m[at];
        if (!std::isfinite(depth)) continue;
        float hollow = 0;
        for (const auto& o : around) {
          const int nx = std::clamp(x + o.dx, 0, width - 1), ny = std::clamp(y + o.dy, 0, height - 1);
          const float neighbour =
              depth_m[static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) + static_cast<std::size_t>(nx)];
          hollow += std::clamp((depth - neighbour) * per_metre, 0.0F, 1.0F);
        }
        const float light = 1 - strength * std::min(1.0F, 1.3F * hollow / static_cast<float>(around.size()));
        for (std::size_t c = 0; c < 3; ++c)
          rgb[3 * at + c] = static_cast<std::uint8_t>(std::lround(static_cast<float>(rgb[3 * at + c]) * light));
      }
  });
}

}  // namespace bole
