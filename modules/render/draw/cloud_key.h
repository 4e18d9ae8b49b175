// Which cloud has which colour, where several lie over one another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

struct CloudKey {
  std::string name;
  std::optional<Color> color;  // none: a colour map
};

// Points of a cloud in the metres of a chart.
struct CloudDots {
  CloudKey key;
  std::vector<Eigen::Vector2d> points;
};

inline constexpr double cloud_key_line_mm = 4.4;
double cloud_keys_width_mm(const std::vector<CloudKey>& keys);
double cloud_keys_height_mm(const std::vector<CloudKey>& keys);
// Right-aligned below `top_right`; long names are cut.
void draw_cloud_keys(Canvas& canvas, const Eigen::Vector2d& top_right, const std::vector<CloudKey>& keys);
void draw_cloud_keys(Canvas& canvas, const Eigen::Vector2d& top_right, const std::vector<CloudDots>& clouds);

}  // namespace bole::render
