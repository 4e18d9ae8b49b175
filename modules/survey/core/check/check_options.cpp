#include "survey/core/check/check_options.h"

namespace bole::survey {

const OptionTable& option_table(const CheckOptions*) {
  using S = CheckOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Number{"cell", &S::cell, Unit::metre, {0.25, 10}, Tier::advanced,
             "Side of the cells of the maps. Larger cells overlook smaller holes."},
      Option<S, int>{"min_ground_points", &S::min_ground_points, Unit::none, {1, 1000}, Tier::expert,
                     "Ground points from which the ground of a cell counts as seen."},
      Number{"max_unseen", &S::max_unseen_pct, Unit::percent, {0, 100}, Tier::basic,
             "Share of the plot whose ground may be unseen before the verdict is look."},
      Number{"walk_again_unseen", &S::walk_again_unseen_pct, Unit::percent, {0, 100}, Tier::basic,
             "Share of the plot whose ground may be unseen before the verdict is walk again."},
      Number{"max_hole", &S::max_hole_m2, Unit::square_metre, {0, 10000}, Tier::basic,
             "Largest connected area of unseen ground that is accepted."},
      Number{"max_walk_gap", &S::max_walk_gap, Unit::metre, {1, 100}, Tier::basic,
             "Distance from the walk that is accepted everywhere. Farther places count as not walked when the rest of "
             "the plot was walked more closely."},
      Number{"min_view_span", &S::min_view_span_deg, Unit::degree, {0, 360}, Tier::basic,
             "Angle that the directions of view of a cell must span, or the cell counts as seen from one side."},
      Number{"max_one_sided", &S::max_one_sided_pct, Unit::percent, {0, 100}, Tier::basic,
             "Share of the plot that may be seen from one side only."},
      Number{"min_density", &S::min_density_pct, Unit::percent, {0, 100}, Tier::advanced,
             "Ground points of a cell, as a share of the median cell, below which it counts as sparse. Sparse cells "
             "are reported where they are more than max_one_sided of the plot."},
      Number{"max_pass_spread", &S::max_pass_spread_cm, Unit::centimetre, {0.1, 100}, Tier::basic,
             "Distance between the surfaces of two passes that is accepted (median over the plot)."},
      Number{"walk_again_spread", &S::walk_again_spread_cm, Unit::centimetre, {0.1, 1000}, Tier::basic,
             "Distance between the surfaces of two passes from which the verdict is walk again."},
      Number{"max_wall", &S::max_wall_cm, Unit::centimetre, {0.1, 100}, Tier::basic,
             "Scatter of the points about the bark that is accepted (median over the stems). Allow more for a sensor "
             "with more noise."},
      Number{"max_loop_residual", &S::max_loop_residual, Unit::metre, {0.001, 100}, Tier::basic,
             "Disagreement between a loop closure and the final trajectory that is accepted."},
      Number{"max_loop_turn", &S::max_loop_turn_deg, Unit::degree, {0.01, 180}, Tier::advanced,
             "The same as an angle."},
      Number{"max_tilt", &S::max_tilt_deg, Unit::degree, {0.05, 45}, Tier::basic,
             "Common lean of the stems that is accepted. More means a tilted frame, or a stand that leans."},
      Option<S, int>{"targets", &S::targets, Unit::none, {0, 2}, Tier::basic,
                     "Number of targets that stood in the plot. 0: none was needed."},
      Number{"target_distance", &S::target_distance, Unit::metre, {0, 1000}, Tier::basic,
             "Distance of the two targets by tape. 0: not known."},
      Number{"target_tolerance", &S::target_tolerance, Unit::metre, {0.001, 10}, Tier::advanced,
             "Difference from target_distance that is accepted."},
      Option<S, BoundaryRule>{"boundary_rule", &S::boundary_rule, Tier::basic,
                              "Trees at the boundary that are in. centre: centre at breast height inside; base: centre "
                              "of the foot inside; whole: the whole stem inside; any_part: any part of it; half: any "
                              "part on the southern and western edges, the whole stem on the others."},
      Number{"position_se", &S::position_se_cm, Unit::centimetre, {0, 100}, Tier::advanced,
             "Standard error of a stem's place against the boundary. Trees nearer than twice this are in doubt."},
      Number{"max_doubtful", &S::max_doubtful_pct, Unit::percent, {0, 100}, Tier::advanced,
             "Share of the basal area that trees in doubt at the boundary may hold."},
      Number{"min_missed_dbh", &S::min_missed_dbh_cm, Unit::centimetre, {2, 200}, Tier::advanced,
             "Diameter from which an upright round structure without a stem in the table is reported."},
      Number{"max_without_ground", &S::max_without_ground_pct, Unit::percent, {0, 100}, Tier::advanced,
             "Share of the stems that may stand where no ground was seen within 1 m."},
      Unless{"targets", {"0", "1"}, {"target_distance"}},
      Unless{"target_distance", {"0"}, {"target_tolerance"}},
  });
  return table;
}

}  // namespace bole::survey
