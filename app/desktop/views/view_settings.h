// What a person sets about the look of the 3-D view.
#pragma once

#include <optional>
#include <string>

#include "render/scene/point_layer.h"

namespace bole::desktop {

struct ViewSettings {
  std::string color = "height_above_ground";  // an array of the cloud
  std::string color_map;  // of numbers, by its name in render/draw/color_maps.h; empty: that of the array
  std::optional<render::Interval> color_range;  // of numbers; else percentiles of the array
  render::PointFilter filter;
  std::optional<render::ClipBox> clip;
  double point_size_px = 2;
  bool eye_dome = false;  // shading of the picture at rest
  bool grid = false;
  bool terrain = false;  // as a surface with contour lines
  bool legend = true, scale_bar = true, north = true;
  bool trees = true;  // their numbers, with symbols for quality and decisions
  bool map = true;    // behind the survey, where there is one
  double map_opacity = 1;
  bool map_on_terrain = false;  // else flat, at the foot of the survey
};

}  // namespace bole::desktop
