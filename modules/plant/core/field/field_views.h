// The pictures that a field is trained on and tested with, in memory and made smaller.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/run.h"
#include "plant/core/surface/depth_maps.h"
#include "plant/core/surface/posed_views.h"

namespace bole::plant {

struct FieldView {
  std::size_t index = 0;  // in the source
  double time_s = 0;
  std::string name;
  bool held_out = false;
  CameraModel camera;  // of the smaller picture
  Pose T_world_camera = Pose::Identity();
  std::shared_ptr<const PixelDirections> directions;
  ColorImage color;
  MaskImage mask;    // 255 where the picture shows the object alone; empty where it is not known or not asked for
  DepthImage depth;  // registered to the picture, metres along z; 0: none; negative: too near an edge to be trusted
};

struct FieldViewOptions {
  int max_width = 640;  // pictures wider than about 1.5 times this are made smaller by a whole number
  int hold_out = 8;     // every n-th view is kept back where the data do not say which; 0: none
  DepthNoise noise;
  bool depth = true;  // read it where there is any
  // Read masks, and lay the object over a surrounding of this value (0 to 255).
  std::optional<std::uint8_t> around_object{};
};

std::vector<FieldView> load_field_views(const ViewSource& views, const std::vector<PosedView>& posed,
                                        const FieldViewOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
