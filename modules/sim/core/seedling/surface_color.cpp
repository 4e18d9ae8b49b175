#include "sim/core/seedling/surface_color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

using Rgb = Eigen::Array3f;

Rgb mixed(const Rgb& a, const Rgb& b, float share) { return a + (b - a) * std::clamp(share, 0.0F, 1.0F); }
Rgb kept(const Rgb& c) { return c.max(0.01F).min(0.92F); }

// 1 on a line of width `line`, 0 beside it, smooth over the footprint.
float line_share(float distance, float line, float foot) {
  const float soft = std::max(foot, 1e-5F);
  return std::clamp((0.5F * line - distance) / soft + 0.5F, 0.0F, 1.0F);
}

float drawn(std::uint64_t seed, int a, int b, int c = 0) {
  const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
  return static_cast<float>(static_cast<double>(mix64(mix64(seed + static_cast<std::uint64_t>(c)) ^ key) >> 40) *
                            0x1.0p-24);
}

}  // namespace

SurfaceColors::SurfaceColors(std::uint64_t seed)
    : seed_(mix64(seed ^ 0x7e87)), cloud_(mix64(seed + 11), 256, 0.62), grain_(mix64(seed + 12), 256, 0.95) {
  Random random(seed, Stream::texture);
  static const std::array<Rgb, 4> tables{Rgb(0.42F, 0.27F, 0.15F), Rgb(0.55F, 0.42F, 0.28F), Rgb(0.30F, 0.30F, 0.32F),
                                         Rgb(0.25F, 0.15F, 0.09F)};
  static const std::array<Rgb, 4> pots{Rgb(0.45F, 0.17F, 0.09F), Rgb(0.06F, 0.06F, 0.065F), Rgb(0.55F, 0.55F, 0.52F),
                                       Rgb(0.10F, 0.20F, 0.30F)};
  table_tone_ = tables[static_cast<std::size_t>(random.index(4))];
  pot_tone_ = pots[static_cast<std::size_t>(random.index(4))];
  wall_tone_ = Rgb(0.6F, 0.58F, 0.53F) * static_cast<float>(random.uniform(0.75, 1.15));
}

SurfaceColor SurfaceColors::leaf(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const {
  const auto [yellow, hue, brightness, phase] = part.tone;
  const float along = uv.x(), across = std::abs(uv.y());
  // Side veins leave the midrib at about 50 degrees, nine to a side; widths in shares of the half width.
  const float vein_place = (along - 0.35F * across) * 9 + phase;
  const float vein_distance = std::abs(vein_place - std::round(vein_place)) / 9;
  const float soft = foot / 0.015F;  // of the footprint in half widths
  const float midrib = line_share(across, 0.10F, soft);
  const float vein = line_share(vein_distance, 0.012F, soft * 0.3F) * (1 - 0.5F * across);
  const float u = along * 0.9F + phase, v = uv.y() * 0.25F + phase * 0.37F;
  const float mottle = cloud_.at(u, v, foot / 0.06F), dots = grain_.at(3 * u, 3 * v, foot / 0.02F);
  Rgb green(0.060F + 0.012F * hue, 0.155F + 0.02F * hue, 0.032F);
  const Rgb ill(0.34F, 0.33F, 0.05F);
  green = mixed(green, ill, 0.8F * yellow * (0.6F + 0.4F * across) + 0.10F * yellow * mottle);
  green *= brightness * (1 + 0.10F * mottle + 0.09F * dots);
  const Rgb pale = green * 1.7F + Rgb(0.03F, 0.035F, 0.015F);
  SurfaceColor c;
  c.rgb = mixed(green, pale, std::max(0.75F * midrib, 0.38F * vein));
  if (part.under) c.rgb = c.rgb * 0.8F + Rgb(0.07F, 0.095F, 0.05F);
  c.rgb = kept(c.rgb);
  c.through = Rgb(0.10F, 0.20F, 0.02F) * (1 - 0.6F * std::max(midrib, vein));
  c.infrared = 0.48F * (1 + 0.05F * mottle);
  c.gloss = part.under ? 0.006F : 0.035F * (1 + 0.15F * dots);
  return c;
}

SurfaceColor SurfaceColors::wood(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const {
  // tone[0]: 0 a stem (brown at its base), 1 a petiole (green).
  const float streak = cloud_.at(uv.x() / 0.15F + part.tone[3], uv.y() / 0.02F, foot / 0.02F);
  const float spots = grain_.at(uv.x() / 0.03F, uv.y() / 0.03F + part.tone[3], foot / 0.03F);
  const Rgb green(0.115F, 0.165F, 0.045F), brown(0.20F, 0.155F, 0.09F);
  const float age = part.tone[0] > 0.9F ? 0 : std::clamp(1.15F - uv.x() / 0.16F - part.tone[0], 0.0F, 1.0F);
  SurfaceColor c;
  c.rgb = kept(mixed(green, brown, age + 0.12F * streak * (age > 0 ? 1.0F : 0.0F)) *
               (1 + 0.14F * streak + 0.13F * spots + (spots > 1.6F ? 0.35F : 0.0F)));
  c.infrared = 0.42F * (1 + 0.06F * streak);
  c.gloss = 0.004F;
  return c;
}

SurfaceColor SurfaceColors::soil(const Eigen::Vector2f& uv, float foot) const {
  const float lumps = cloud_.at(uv.x() / 0.06F, uv.y() / 0.06F, foot / 0.06F);
  const float grains = grain_.at(uv.x() / 0.04F + 0.3F, uv.y() / 0.04F, foot / 0.04F);
  SurfaceColor c;
  c.rgb = Rgb(0.085F, 0.060F, 0.042F) * (1 + 0.25F * lumps + 0.35F * grains);
  if (grains + 0.5F * lumps > 2.0F) c.rgb = Rgb(0.55F, 0.53F, 0.48F);  // perlite
  c.rgb = kept(c.rgb);
  c.infrared = 0.22F * (1 + 0.2F * grains);
  return c;
}

SurfaceColor SurfaceColors::pot(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const {
  const float stain = cloud_.at(uv.x() / 0.2F + part.tone[0], uv.y() / 0.2F, foot / 0.2F);
  const float fine = grain_.at(uv.x() / 0.06F, uv.y() / 0.06F + part.tone[1], foot / 0.06F);
  SurfaceColor c;
  c.rgb = kept(mixed(pot_tone_, Rgb(0.45F, 0.42F, 0.36F), 0.10F + 0.12F * stain) * (1 + 0.10F * fine));
  c.infrared = 0.35F * (1 + 0.1F * stain);
  c.gloss = 0.008F;
  return c;
}

SurfaceColor SurfaceColors::mat(const Eigen::Vector2f& uv, float foot) const {
  const float paper = cloud_.at(uv.x() / 0.3F, uv.y() / 0.3F, foot / 0.3F);
  const auto black = static_cast<float>(board_.black(uv.cast<double>(), foot));
  SurfaceColor c;
  c.rgb = kept(mixed(Rgb(0.80F, 0.80F, 0.78F) * (1 + 0.015F * paper), Rgb::Constant(0.035F), black));
  c.infrared = 0.78F - 0.68F * black;
  return c;
}

SurfaceColor SurfaceColors::table(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const {
  constexpr float plank = 0.14F;
  const float row = std::floor(uv.y() / plank);
  const float tone = drawn(seed_, static_cast<int>(row), 7);
  const float seam = line_share(std::abs(uv.y() - plank * std::round(uv.y() / plank)), 0.0015F, foot);
  const float streak = cloud_.at(uv.x() / 0.9F + 5 * tone, uv.y() / 0.12F, foot / 0.12F);
  const float grain = grain_.at(uv.x() / 0.5F + tone, uv.y() / 0.07F, foot / 0.07F);
  const float stain = cloud_.at(uv.x() / 0.7F + 0.2F, uv.y() / 0.7F + part.tone[0], foot / 0.7F);
  SurfaceColor c;
  c.rgb = kept(table_tone_ * (0.8F + 0.4F * tone) * (1 + 0.18F * streak + 0.14F * grain + 0.10F * stain) *
               (1 - 0.7F * seam));
  c.infrared = 0.5F * (1 + 0.12F * streak + 0.1F * grain);
  c.gloss = 0.004F;
  return c;
}

// Walls with posters, and things on the table: panels of different colours with their own pattern.
SurfaceColor SurfaceColors::wall(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const {
  const bool thing = part.surface == PartSurface::box;
  const float size = thing ? 0.07F : 0.45F;
  const int i = static_cast<int>(std::floor(uv.x() / size)), k = static_cast<int>(std::floor(uv.y() / size));
  const auto key = static_cast<int>(part.tone[0] * 1e6F);
  const Rgb panel(drawn(seed_ + 1, i, k, key), drawn(seed_ + 2, i, k, key), drawn(seed_ + 3, i, k, key));
  const float soft = cloud_.at(uv.x() / (4 * size) + part.tone[1], uv.y() / (4 * size), foot / (4 * size));
  const float fine = cloud_.at(uv.x() / size + part.tone[2], uv.y() / size, foot / size);
  SurfaceColor c;
  const bool poster = thing || drawn(seed_ + 4, i, k, key) < 0.35F;
  const Rgb base = poster ? Rgb(0.08F + 0.6F * panel) : wall_tone_;
  c.rgb = kept(base * (1 + (poster ? 0.35F : 0.05F) * fine + 0.06F * soft));
  c.infrared = 0.45F * (1 + 0.15F * fine);
  return c;
}

SurfaceColor SurfaceColors::at(const ScenePart& part, const Eigen::Vector2f& uv, float footprint) const {
  switch (part.surface) {
    case PartSurface::leaf:
      return leaf(part, uv, footprint);
    case PartSurface::wood:
      return wood(part, uv, footprint);
    case PartSurface::pot:
      return pot(part, uv, footprint);
    case PartSurface::soil:
      return soil(uv, footprint);
    case PartSurface::mat:
      return mat(uv, footprint);
    case PartSurface::table:
      return table(part, uv, footprint);
    case PartSurface::wall:
    case PartSurface::box:
      break;
  }
  return wall(part, uv, footprint);
}

}  // namespace bole::sim
