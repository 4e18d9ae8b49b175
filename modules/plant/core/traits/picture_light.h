// Whether the pictures of a plant hold sRGB codes or light.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "plant/core/traits/stem_strips.h"

namespace bole::plant {

struct PictureLightFound {
  bool srgb = true;  // false: codes are light
  double doubt = 0;  // of a diameter, as a share, where neither the pictures nor the stem tell
};

// Steps from dark to bright in the views `few` tell it. Where they do not, the edges of the stem itself do (`strips`
// finds them, with codes taken for light or not); where those do not either, the usual curve is taken. Counts and the
// answer go into `report`.
PictureLightFound judge_picture_light(const ViewSource& views, const std::vector<std::uint32_t>& few,
                                      const std::function<StripsFound(bool linear_light)>& strips, Report& report,
                                      const Run& run);

}  // namespace bole::plant
