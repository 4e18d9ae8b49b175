#include "render/draw/color.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::render {
namespace {

// OKLab (B. Ottosson 2020, "A perceptual color space for image processing") to sRGB.
Color from_oklch(double lightness, double chroma, double hue_rad) {
  const double a = chroma * std::cos(hue_rad), b = chroma * std::sin(hue_rad);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const auto encode = [](double linear) {
    const double v = std::clamp(linear, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  };
  return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

std::vector<Color> colors(std::initializer_list<std::uint32_t> values) {
  std::vector<Color> list;
  for (const auto v : values) list.push_back(hex(v));
  return list;
}

}  // namespace

Color mix(const Color& a, const Color& b, double t) {
  return {std::lerp(a.r, b.r, t), std::lerp(a.g, b.g, t), std::lerp(a.b, b.b, t), std::lerp(a.a, b.a, t)};
}

Color quality_color(std::string_view quality) {
  if (quality == "good") return ink::good;
  if (quality == "fair") return ink::fair;
  if (quality == "poor") return ink::poor;
  return ink::muted;
}

Color ColorMap::at(double t) const {
  if (std::isnan(t)) return hex(0xb0b0b0);
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(anchors_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), anchors_.size() - 2);
  return mix(anchors_[i], anchors_[i + 1], at - static_cast<double>(i));
}

const ColorMap& ColorMap::viridis() {
  static const ColorMap map(colors(
      {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725}));
  return map;
}

const ColorMap& ColorMap::cividis() {
  static const ColorMap map(
      colors({0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838}));
  return map;
}

const ColorMap& ColorMap::diverging() {
  static const ColorMap map(colors({0x2166ac, 0x67a9cf, 0xd1e5f0, 0xf0f0f0, 0xfddbc7, 0xef8a62, 0xb2182b}));
  return map;
}

Color id_color(std::int64_t id) {
  if (id <= 0) return hex(0xb8bdc1);
  constexpr double golden_angle = std::numbers::pi * (3 - 2.2360679774997896);
  constexpr double lightness[] = {0.66, 0.78, 0.55};
  return from_oklch(lightness[id % 3], 0.125, std::fmod(static_cast<double>(id) * golden_angle, 2 * std::numbers::pi));
}

}  // namespace bole::render
