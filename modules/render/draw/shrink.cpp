#include "render/draw/shrink.h"

namespace bole::render {

Image shrunk(std::span<const std::uint8_t> rgb, int width, int height, int samples) {
  const auto supersampling = static_cast<unsigned>(samples);
  Image image{width, height,
              std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  const auto* source = rgb.data();
  const std::size_t row = std::size_t{3} * static_cast<std::size_t>(width) * supersampling;
  auto* target = image.rgba.data();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        unsigned sum = 0;
        for (std::size_t sy = 0; sy < supersampling; ++sy)
          for (std::size_t sx = 0; sx < supersampling; ++sx)
            sum += source[(static_cast<std::size_t>(height - 1 - y) * supersampling + sy) * row +
                          3 * (static_cast<std::size_t>(x) * supersampling + sx) + c];
        *target++ =
            static_cast<std::uint8_t>((sum + supersampling * supersampling / 2) / (supersampling * supersampling));
      }
      *target++ = 255;
    }
  return image;
}

}  // namespace bole::render
