#include "render/beside/ground_places.h"

#include <algorithm>

namespace bole::render {
namespace {

constexpr int rgba_channels = 4;

std::array<std::uint8_t, rgba_channels> mean_of(const GroundPicture& picture, int column, int row, int step) {
  const int columns = std::min(step, picture.width - column), rows = std::min(step, picture.height - row);
  std::array<std::uint32_t, rgba_channels> sums{};  // colours times alpha
  for (int y = row; y < row + rows; ++y) {
    const auto* pixel =
        picture.rgba.data() + rgba_channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                               static_cast<std::size_t>(column));
    for (int x = 0; x < columns; ++x, pixel += rgba_channels) {
      for (std::size_t c = 0; c < 3; ++c) sums[c] += static_cast<std::uint32_t>(pixel[c]) * pixel[3];
      sums[3] += pixel[3];
    }
  }
  std::array<std::uint8_t, rgba_channels> mean{};
  if (sums[3] == 0) return mean;
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((sums[c] + sums[3] / 2) / sums[3]);
  mean[3] = static_cast<std::uint8_t>(sums[3] / static_cast<std::uint32_t>(columns * rows));
  return mean;
}

}  // namespace

GroundPicture coarser(const GroundPicture& picture, int step) {
  GroundPicture out;
  out.width = (picture.width + step - 1) / step;
  out.height = (picture.height + step - 1) / step;
  out.rgba.reserve(static_cast<std::size_t>(rgba_channels) * static_cast<std::size_t>(out.width) *
                   static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (const auto value : mean_of(picture, x * step, y * step, step)) out.rgba.push_back(value);
  return out;
}

GroundPlaces flat_ground(const GroundCorners& corners, double z) {
  GroundPlaces places{2, 2, {}, true};
  for (const std::size_t k : {0, 1, 3, 2}) places.at.emplace_back(corners[k].x(), corners[k].y(), z);
  return places;
}

}  // namespace bole::render
