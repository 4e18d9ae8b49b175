#include "steering/core/track/navigate_track.h"

namespace bole::steering {

const OptionTable& option_table(const NavigateOptions*) {
  using S = NavigateOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Number{"antenna_forward",
             &S::antenna_forward,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Distance of the antenna ahead of the control point (middle of the rear axle on the ground)."},
      Number{"antenna_left",
             &S::antenna_left,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Distance of the antenna to the left of the control point."},
      Number{"antenna_up",
             &S::antenna_up,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Height of the antenna above the control point. It counts where roll and pitch are known."},
      Option<S, HeadingSource>{"heading", &S::heading, Tier::advanced,
                               "Heading that turns the lever arm: measured (two antennas or attitudes), course of the "
                               "receiver, or direction of motion. auto: the first of these that a fix has."},
      Number{"heading_offset",
             &S::heading_offset_deg,
             Unit::degree,
             {-360, 360},
             Tier::advanced,
             "Angle by which the measured heading is turned clockwise from the vehicle's, as antennas mounted across "
             "it give."},
      Option<S, std::string>{
          "accept",
          &S::accept,
          TextKind::plain,
          {},
          Tier::basic,
          "Fix qualities that are used, as numbers of GGA sentences: 1 single, 2 differential, 4 RTK "
          "fixed, 5 RTK float."},
      Option<S, std::optional<double>>{"position_sigma",
                                       &S::position_sigma,
                                       Unit::metre,
                                       {1e-4, 100},
                                       "auto",
                                       Tier::basic,
                                       "Standard deviation per axis of a fix. auto: as the receiver gives it, else by "
                                       "the fix quality, else 1 cm."},
      Number{"acceleration_sigma",
             &S::acceleration_sigma,
             Unit::none,
             {1e-4, 100},
             Tier::advanced,
             "Standard deviation of the acceleration of the vehicle, m/s2. A larger value smooths less."},
      Number{"gate",
             &S::gate,
             Unit::none,
             {1, 1000},
             Tier::advanced,
             "Distance from the prediction, in standard deviations, beyond which a fix is doubted."},
      Number{"patience",
             &S::patience,
             Unit::second,
             {0, 600},
             Tier::advanced,
             "Time for which doubted fixes are ignored. Then the filter starts again at the new position."},
      Number{"max_gap",
             &S::max_gap,
             Unit::second,
             {0.1, 3600},
             Tier::advanced,
             "The filter starts anew after a longer time without fixes."},
  });
  return table;
}

}  // namespace bole::steering
