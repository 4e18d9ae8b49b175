// Stems of a synthetic cloud, measured with its own terrain.
#pragma once

#include "stems/core/measure_stems.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {

// Fewer rays than a walk gives, for tests that measure many stems.
inline synthetic::StemCloudOptions coarse() {
  synthetic::StemCloudOptions o;
  o.pass_step = 0.5, o.azimuth_step = 0.4;
  return o;
}

inline StemSurvey measure(const synthetic::StemCloud& cloud, const MeasureOptions& options = {}) {
  return measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, options, {});
}

}  // namespace bole::stems
