// A cloud beside a survey as it is drawn.
#pragma once

#include <memory>

#include "cloud/point_cloud.h"
#include "render/scene/point_paint.h"

namespace bole::render {

struct BesideCloud {
  std::shared_ptr<const PointCloud> points;  // where it is placed; never null
  PointPaint paint;
  double point_px = 0;  // 0: as the survey
  double opacity = 1;   // 0 to 1; 1: nothing shines through
};

}  // namespace bole::render
