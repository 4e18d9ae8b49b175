// The colours of all surfaces: what share of the light they send back.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/core/seedling/charuco_mat.h"
#include "sim/core/seedling/noise_texture.h"
#include "sim/core/seedling/scene_part.h"

namespace bole::sim {

struct SurfaceColor {
  Eigen::Array3f rgb = Eigen::Array3f::Zero();      // linear, 0 to 1
  Eigen::Array3f through = Eigen::Array3f::Zero();  // share of the light of the other side
  float infrared = 0;
  float gloss = 0;  // strength of the highlight
};

class SurfaceColors {
 public:
  explicit SurfaceColors(std::uint64_t seed);

  // `uv` as in ScenePart; `footprint` (metres) is the width of what a sample of the picture sees.
  SurfaceColor at(const ScenePart& part, const Eigen::Vector2f& uv, float footprint) const;

 private:
  SurfaceColor leaf(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor wood(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor soil(const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor pot(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor mat(const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor table(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const;
  SurfaceColor wall(const ScenePart& part, const Eigen::Vector2f& uv, float foot) const;

  std::uint64_t seed_;
  CharucoMat board_;
  NoiseTexture cloud_, grain_;
  Eigen::Array3f table_tone_, pot_tone_, wall_tone_;
};

}  // namespace bole::sim
