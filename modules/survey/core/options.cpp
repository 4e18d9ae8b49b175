#include "survey/core/options.h"

namespace bole::survey {

const OptionTable& option_table(const FrameOptions*) {
  using S = FrameOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"level",
                             &S::level,
                             TextKind::choice,
                             {"stems", "ground", "none"},
                             Tier::basic,
                             "What tells the vertical: the mean direction of the stems (ground when there are too "
                             "few), the plane of the ground (level plots only), or none (z is up already)."},
      Option<S, double>{"intensity_min",
                        &S::intensity_min,
                        Unit::none,
                        {0.0, 1e6},
                        Tier::basic,
                        "Returns stronger than this come from retro-reflective surfaces (Velodyne: above 100)."},
      Option<S, int>{"target_points_min",
                     &S::target_points_min,
                     Unit::none,
                     {3, 1'000'000},
                     Tier::advanced,
                     "Fewest strong returns on a target."},
      Option<S, double>{"target_size",
                        &S::target_size_m,
                        Unit::metre,
                        {0.05, 5.0},
                        Tier::advanced,
                        "Greatest extent of a target; larger groups of strong returns (signs, vehicles) are rejected."},
      Option<S, double>{"target_views",
                        &S::target_views_m,
                        Unit::metre,
                        {0.0, 100.0},
                        Tier::advanced,
                        "A target is seen from sensor positions at least this far apart; what is not (jackets, glints) "
                        "is rejected. Not checked when the cloud has no sensor positions."},
      Option<S, double>{
          "target_distance",
          &S::target_distance_m,
          Unit::metre,
          {0.0, 1000.0},
          Tier::basic,
          "Horizontal distance between the centre and the north target as set out in the field; 0: not known."},
      Option<S, double>{"target_tolerance",
                        &S::target_tolerance_m,
                        Unit::metre,
                        {0.01, 50.0},
                        Tier::advanced,
                        "How far the measured distance of the targets may be from target_distance."},
      Option<S, double>{"north_bearing",
                        &S::north_bearing_deg,
                        Unit::degree,
                        {-360.0, 360.0},
                        Tier::basic,
                        "Bearing from the centre to the north target, clockwise from grid north."},
      Option<S, double>{"most_tilt",
                        &S::most_tilt_deg,
                        Unit::degree,
                        {1.0, 60.0},
                        Tier::expert,
                        "Greatest tilt of the map that is looked for."},
      Option<S, int>{
          "stems_min", &S::stems_min, Unit::none, {3, 1000}, Tier::expert, "Fewest stems that may tell the vertical."},
      Unless{"target_distance", {"0"}, {"target_tolerance"}},
      Unless{"level", {"none"}, {"most_tilt"}},
      OnlyIf{"level", {"stems"}, {"stems_min"}},
  });
  return table;
}

}  // namespace bole::survey
