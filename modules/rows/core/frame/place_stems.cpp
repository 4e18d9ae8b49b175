#include "rows/core/frame/place_stems.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace bole::rows {

Table place_stems(const Table& stems, const PlaceOptions& options, const Table* pose) {
  const bool by_hand = options.x != 0 || options.y != 0 || options.yaw_deg != 0;
  PlaceOptions o = options;
  if (pose != nullptr) {
    if (by_hand)
      throw bad_input("the place of the sensor is given twice, by the options and by its marks", "one of the two",
                      "Leave out x, y and yaw");
    if (pose->rows() != 1) throw bad_input(fmt::format("{} poses of the sensor", pose->rows()), "one");
    o = {pose->numbers("x_m")[0], pose->numbers("y_m")[0], pose->numbers("yaw_deg")[0]};
    if (!std::isfinite(o.x + o.y + o.yaw_deg)) throw bad_input("the pose of the sensor is not finite", "numbers");
  }
  const double c = std::cos(o.yaw_deg * rad_per_deg), s = std::sin(o.yaw_deg * rad_per_deg);
  auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double px = x[i], py = y[i];
    x[i] = o.x + c * px - s * py;
    y[i] = o.y + s * px + c * py;
  }
  Table placed = stems;
  placed.set("x_m", std::move(x));
  placed.set("y_m", std::move(y));
  // Without a place the axes stay those of the frame, whose y need not point north.
  if (by_hand || pose != nullptr) placed.facts["axes"] = "global";
  if (pose == nullptr) return placed;
  if (const auto crs = pose->facts.find("crs"); crs != pose->facts.end()) placed.facts["crs"] = crs->second;
  if (pose->has("yaw_se_deg")) placed.facts["yaw_se_deg"] = number_text(pose->numbers("yaw_se_deg")[0]);
  return placed;
}

}  // namespace bole::rows
