#include "rows/core/frame/sensor_pose.h"

namespace bole::rows {

const OptionTable& option_table(const ResectOptions*) {
  using S = ResectOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Option<S, ResectMethod>{"method", &S::method, Tier::basic,
                              "vectors: least squares over all coordinates of the marks as they are seen; ranges: the "
                              "position from the ranges alone and the heading from directions, as in the paper."},
      Number{"roll",
             &S::roll_deg,
             Unit::degree,
             {-180, 180},
             Tier::basic,
             "Roll of the sensor about its x axis. Leave 0 where the seen coordinates are levelled already."},
      Number{"pitch",
             &S::pitch_deg,
             Unit::degree,
             {-90, 90},
             Tier::basic,
             "Pitch of the sensor about its y axis. Leave 0 where the seen coordinates are levelled already."},
      Number{"mark_sigma",
             &S::mark_sigma,
             Unit::metre,
             {0.0001, 10},
             Tier::basic,
             "Standard deviation per axis of the known positions in plan."},
      Number{"mark_height_sigma",
             &S::mark_height_sigma,
             Unit::metre,
             {0.0001, 10},
             Tier::advanced,
             "Standard deviation of the known heights."},
      Number{"range_sigma",
             &S::range_sigma,
             Unit::metre,
             {0.0001, 1},
             Tier::advanced,
             "Standard deviation of the range to a mark."},
      Number{"direction_sigma",
             &S::direction_sigma_deg,
             Unit::degree,
             {0.0001, 5},
             Tier::advanced,
             "Standard deviation of the direction to a mark."},
      Number{"tilt_sigma",
             &S::tilt_sigma_deg,
             Unit::degree,
             {0.0001, 10},
             Tier::advanced,
             "Standard deviation of the levelling, the same for all marks."},
      Number{"max_sigma",
             &S::max_sigma,
             Unit::metre,
             {0.001, 100},
             Tier::advanced,
             "Largest standard error of the position in plan that is accepted."},
      Number{"max_heading_sigma",
             &S::max_heading_sigma_deg,
             Unit::degree,
             {0.001, 90},
             Tier::advanced,
             "Largest standard error of the heading that is accepted."},
      OnlyIf{"method", {"vectors"}, {"tilt_sigma"}},
  });
  return table;
}

}  // namespace bole::rows
