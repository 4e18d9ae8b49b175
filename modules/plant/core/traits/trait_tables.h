// Traits as tables.
#pragma once

#include <optional>
#include <string>

#include "base/transform.h"
#include "cloud/core/view_source.h"
#include "cloud/table.h"
#include "plant/core/traits/extents.h"
#include "plant/core/traits/stem_fit.h"

namespace bole::plant {

// A value with its 95 % interval, in metres. `high` is NaN where the plant was cut off: then nothing is known above.
struct Interval {
  double value = 0, low = 0, high = 0;
};

struct TraitRow {
  std::string plant_id;
  Interval height, length, width, stem;
  double stem_height = 0;
  std::string stem_method;
  bool scale_known = true;

  // Where they were measured.
  Pose T_world_plant = Pose::Identity();
  PlanRectangle rectangle;  // plant axes
};

// One row. base_*_m is the foot of the stem, breadth_x_m and breadth_y_m the middle of the rectangle of the breadth and
// breadth_angle_deg the direction of its length from x towards y: all in world axes.
Table trait_table(const TraitRow& row);
// stem_volume_cm3 with its interval; NaN where it is not known.
void set_volume(Table& traits, const std::optional<Interval>& volume_m3);
std::string size_sentence(const TraitRow& row);

// height_mm, x_m, y_m, z_m (plant axes), diameter_mm with its interval, which is as wide as that at `stem_height`,
// source.
Table stem_table(const std::optional<CloudStem>& cloud, const std::optional<StemFit>& fit,
                 const std::vector<StemStrip>& strips, double stem_height, const Interval& at_stem_height);

Table contour_table(const StripsFound& found, const ViewSource* views, const std::optional<StemFit>& fit);

}  // namespace bole::plant
