// Images in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bole {
inline namespace camera {

// Rows from the top, pixels from the left, channels side by side. Pixel (0, 0) is the centre of the first pixel, so the
// image reaches from -0.5 to width - 0.5.
template <class T>
struct Image {
  int width = 0, height = 0, channels = 1;
  std::vector<T> values;

  Image() = default;
  Image(int image_width, int image_height, int image_channels = 1, T value = T{})
      : width(image_width),
        height(image_height),
        channels(image_channels),
        values(static_cast<std::size_t>(image_width) * static_cast<std::size_t>(image_height) *
                   static_cast<std::size_t>(image_channels),
               value) {}

  bool empty() const { return values.empty(); }
  std::size_t index(int x, int y, int channel = 0) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels) +
           static_cast<std::size_t>(channel);
  }
  T& at(int x, int y, int channel = 0) { return values[index(x, y, channel)]; }
  const T& at(int x, int y, int channel = 0) const { return values[index(x, y, channel)]; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

using ColorImage = Image<std::uint8_t>;  // three channels: red, green, blue, as stored (sRGB)
using DepthImage = Image<float>;         // metres along the camera's z; 0 where there is none
using MaskImage = Image<std::uint8_t>;   // 0 or 255

}  // namespace camera
}  // namespace bole
