#include "survey/core/options.h"

namespace bole::survey {

const OptionTable& option_table(const FrameOptions*) {
  using S = FrameOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, Level>{
          "level", &S::level, Tier::basic,
          "What gives the vertical. auto: gravity where the map was made with an inertial unit that tells it to "
          "0.3 deg, else the stems; gravity: z is up, as the unit told; stems: their mean direction, the "
          "ground where there are too few; ground: its plane, for level plots only; none: z is up already."},
      Option<S, double>{"min_intensity",
                        &S::min_intensity,
                        Unit::none,
                        {0.0, 1e6},
                        Tier::basic,
                        "Returns stronger than this come from retro-reflective surfaces (Velodyne: above 100)."},
      Option<S, int>{"min_target_points",
                     &S::min_target_points,
                     Unit::none,
                     {3, 1'000'000},
                     Tier::advanced,
                     "Fewest strong returns on a target."},
      Option<S, double>{"target_size",
                        &S::target_size,
                        Unit::metre,
                        {0.05, 5.0},
                        Tier::advanced,
                        "Greatest extent of a target as one position sees it. Larger groups of strong returns (signs, "
                        "vehicles) are rejected."},
      Option<S, double>{"target_views",
                        &S::target_views,
                        Unit::metre,
                        {0.0, 100.0},
                        Tier::advanced,
                        "A target must be seen from sensor positions at least this far apart. This rejects reflective "
                        "jackets and glints; it is not checked where the cloud has no sensor positions."},
      Option<S, double>{
          "target_distance",
          &S::target_distance,
          Unit::metre,
          {0.0, 1000.0},
          Tier::basic,
          "Horizontal distance between the centre and the north target as set out in the field; 0: not known."},
      Option<S, double>{"target_tolerance",
                        &S::target_tolerance,
                        Unit::metre,
                        {0.01, 50.0},
                        Tier::advanced,
                        "Greatest difference between the measured distance of the targets and target_distance."},
      Option<S, double>{"north_bearing",
                        &S::north_bearing_deg,
                        Unit::degree,
                        {-360.0, 360.0},
                        Tier::basic,
                        "Bearing from the centre to the north target, clockwise from grid north."},
      Option<S, double>{"max_tilt",
                        &S::max_tilt_deg,
                        Unit::degree,
                        {1.0, 60.0},
                        Tier::expert,
                        "Greatest tilt of the map that is searched."},
      Option<S, int>{
          "min_stems", &S::min_stems, Unit::none, {3, 1000}, Tier::expert, "Fewest stems that may give the vertical."},
      Unless{"target_distance", {"0"}, {"target_tolerance"}},
      Unless{"level", {"none", "gravity"}, {"max_tilt"}},
      OnlyIf{"level", {"auto", "stems"}, {"min_stems"}},
  });
  return table;
}

}  // namespace bole::survey
