// Colours of figures and scenes: inks, perceptual maps, one stable colour per id.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace bole::render {

// sRGB and opacity, each from 0 to 1.
struct Color {
  double r = 0, g = 0, b = 0, a = 1;
  Color with_alpha(double alpha) const { return {r, g, b, alpha}; }
};

constexpr Color hex(std::uint32_t rgb, double alpha = 1) {
  return {((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0, alpha};
}

// From `a` (t = 0) to `b` (t = 1).
Color mix(const Color& a, const Color& b, double t);

// The few inks that all figures share. Distinguishable with the common colour-vision deficiencies.
namespace ink {
inline constexpr Color text = hex(0x1d2327);
inline constexpr Color muted = hex(0x5f6b73);
inline constexpr Color axis = hex(0x3a444b);
inline constexpr Color grid = hex(0xe3e7ea);
inline constexpr Color paper = hex(0xffffff);
inline constexpr Color stem = hex(0x6b4a2f);     // wood
inline constexpr Color good = hex(0x2b7a4b);     // green
inline constexpr Color fair = hex(0xd08a1d);     // amber
inline constexpr Color poor = hex(0xb93a32);     // red
inline constexpr Color primary = hex(0x1f5f8b);  // blue
inline constexpr Color accent = hex(0xd1495b);   // crimson
inline constexpr Color path = hex(0x4a90b8);     // the walk
inline constexpr Color contour = hex(0x6b4a2f);  // lines of equal height of the terrain
}  // namespace ink

// Colour of a quality word ("good", "fair", "poor"); muted for any other.
Color quality_color(std::string_view quality);

// A sequence of anchors, mixed in between; at() clamps t to [0, 1], NaN gives grey.
class ColorMap {
 public:
  explicit ColorMap(std::vector<Color> anchors) : anchors_(std::move(anchors)) {}
  Color at(double t) const;

  static const ColorMap& viridis();    // heights
  static const ColorMap& cividis();    // intensity; the same to colour-blind readers
  static const ColorMap& diverging();  // signed errors: blue, white, red

 private:
  std::vector<Color> anchors_;
};

// The colour of a tree or pass: the same for the same id in every figure and run, neighbouring ids far apart.
Color id_color(std::int64_t id);

}  // namespace bole::render
