#include "evaluation/core/evaluation_options.h"

namespace bole {

const OptionTable& option_table(const EvaluationOptions*) {
  using S = EvaluationOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"match_distance", &S::match_distance_m, Unit::metre, {0.01, 10}, Tier::basic, "A stem and a reference tree may be matched when they stand no further apart than this."},
      Option<S, double>{"dbh_gate", &S::dbh_gate_m, Unit::metre, {0, 5}, Tier::advanced, "Matched diameters may differ by this much; 0 for any difference."},
      Option<S, double>{"min_dbh", &S::min_dbh_m, Unit::metre, {0, 1}, Tier::basic, "Reference trees from this diameter upwards count, and stems from this diameter upwards can be false."},
      Option<S, std::string>{
          "plot_shape", &S::plot_shape, TextKind::choice, {"rectangle", "circle", "none"}, Tier::basic, "Shape of the plot; trees count when their centre at breast height lies inside. None: all count."},
      Option<S, double>{"plot_width", &S::plot_width_m, Unit::metre, {1, 10000}, Tier::basic, "Extent of a rectangular plot in x (east)."},
      Option<S, double>{"plot_height", &S::plot_height_m, Unit::metre, {1, 10000}, Tier::basic, "Extent of a rectangular plot in y (north)."},
      Option<S, double>{"plot_radius", &S::plot_radius_m, Unit::metre, {1, 10000}, Tier::basic, "Radius of a circular plot."},
      Option<S, double>{"plot_x", &S::plot_x_m, Unit::metre, {-1e8, 1e8}, Tier::advanced, "Plot centre, x in the axes of the reference."},
      Option<S, double>{"plot_y", &S::plot_y_m, Unit::metre, {-1e8, 1e8}, Tier::advanced, "Plot centre, y in the axes of the reference."},
      Option<S, double>{"class_width", &S::class_width_m, Unit::metre, {0.01, 1}, Tier::advanced, "Width of the diameter classes."},
      Option<S, double>{"distance_step", &S::distance_step_m, Unit::metre, {0.5, 1000}, Tier::advanced, "Width of the rings around the plot centre by which trees are counted."},
      Option<S, std::string>{"align_stems",
                             &S::align_stems,
                             TextKind::choice,
                             {"none", "shift", "rigid"},
                             Tier::basic,
                             "Before errors are taken, the stems are moved onto the reference as they are (none), by the best shift, or by the best shift and rotation."},
      Option<S, std::string>{
          "align_trajectory", &S::align_trajectory, TextKind::choice, {"se3", "none"}, Tier::basic, "Before errors are taken, the trajectory is moved onto the reference by the best rigid motion, or not."},
      Option<S, double>{"most_time_gap", &S::most_time_gap_s, Unit::second, {0.001, 60}, Tier::advanced, "A pose is compared when reference poses lie on both sides of it, no further apart than this."},
      Option<S, double>{"rpe_step", &S::rpe_step_s, Unit::second, {0.01, 1000}, Tier::advanced, "Time between the two poses of a relative pose error."},
      Option<S, std::string>{"published_plot", &S::published_plot, TextKind::choice, {"none", "1", "2", "3", "4", "overall"}, Tier::advanced, "Plot of the improved-LOAM paper whose published figures stand beside ours."},
  });
  return table;
}

}  // namespace bole
