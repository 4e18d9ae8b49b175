#include "evaluation/core/evaluation_options.h"

namespace bole {

const OptionTable& option_table(const EvaluationOptions*) {
  using S = EvaluationOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"match_distance",
                        &S::match_distance_m,
                        Unit::metre,
                        {0.01, 10},
                        Tier::basic,
                        "A stem and a reference tree may be matched when they stand no further apart than this."},
      Option<S, double>{"dbh_gate",
                        &S::dbh_gate_cm,
                        Unit::centimetre,
                        {0, 500},
                        Tier::advanced,
                        "Matched diameters may differ by this much; 0 for any difference."},
      Option<S, double>{"class_width",
                        &S::class_width_cm,
                        Unit::centimetre,
                        {1, 100},
                        Tier::advanced,
                        "Width of the diameter classes."},
      Option<S, double>{"distance_step",
                        &S::distance_step_m,
                        Unit::metre,
                        {0.5, 1000},
                        Tier::advanced,
                        "Width of the rings around the plot centre by which trees are counted."},
      Option<S, std::string>{"align_stems",
                             &S::align_stems,
                             TextKind::choice,
                             {"none", "shift", "rigid"},
                             Tier::basic,
                             "Before errors are taken, the stems are moved onto the reference as they are (none), by "
                             "the best shift, or by the best shift and rotation."},
      Option<S, std::string>{
          "align_trajectory",
          &S::align_trajectory,
          TextKind::choice,
          {"se3", "none"},
          Tier::basic,
          "Before errors are taken, the trajectory is moved onto the reference by the best rigid motion, or not."},
      Option<S, double>{"most_time_gap",
                        &S::most_time_gap_s,
                        Unit::second,
                        {0.001, 60},
                        Tier::advanced,
                        "A pose is compared when reference poses lie on both sides of it, no further apart than this."},
      Option<S, double>{"rpe_step",
                        &S::rpe_step_s,
                        Unit::second,
                        {0.01, 1000},
                        Tier::advanced,
                        "Time between the two poses of a relative pose error."},
      Option<S, std::string>{"published_plot",
                             &S::published_plot,
                             TextKind::choice,
                             {"none", "1", "2", "3", "4", "overall"},
                             Tier::advanced,
                             "Plot of the improved-LOAM paper whose published figures stand beside ours."},
  });
  return table;
}

}  // namespace bole
