#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

const OptionTable& option_table(const EvaluationOptions*) {
  using S = EvaluationOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"match_distance",
                        &S::match_distance_m,
                        Unit::metre,
                        {0.01, 10},
                        Tier::basic,
                        "Maximum distance between a stem and its reference tree."},
      Option<S, double>{"dbh_gate",
                        &S::dbh_gate_cm,
                        Unit::centimetre,
                        {0, 500},
                        Tier::advanced,
                        "Maximum difference of matched diameters; 0 allows any."},
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
                        "Width of the rings around the plot centre in which trees are counted; needs a plot."},
      Option<S, AlignStems>{
          "align_stems", &S::align_stems, Tier::basic,
          "Alignment of the stems with the reference before errors are computed: none, shift, rigid (shift and "
          "rotation), or search (all rotations and shifts are tried, for maps with another origin and north)."},
      Option<S, std::string>{
          "columns",
          &S::columns,
          TextKind::plain,
          {},
          Tier::advanced,
          "Columns of the stems by other names or units, as NAME=SOURCE:UNIT with commas between: x_m=E, y_m=N, "
          "dbh_cm=DIAM:mm. Units: mm, cm, dm, m, in, ft, deg, gon; azimuth_deg and distance_m give places too."},
      Option<S, std::string>{"rows",
                             &S::rows,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Stems that are evaluated, as COLUMN=VALUE: plot=3; empty for all."},
      Option<S, std::string>{
          "reference_columns",
          &S::reference_columns,
          TextKind::plain,
          {},
          Tier::advanced,
          "Columns of the reference by other names or units, as in columns. Empty: as they are named, else guessed by "
          "their headings."},
      Option<S, std::string>{"reference_rows",
                             &S::reference_rows,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Reference trees that are used, as in rows."},
      Option<S, AlignTrajectory>{"align_trajectory", &S::align_trajectory, Tier::basic,
                                 "Moves the trajectory onto the reference by the best rigid motion (se3) before errors "
                                 "are taken, or not (none)."},
      Option<S, double>{"max_time_gap",
                        &S::max_time_gap,
                        Unit::second,
                        {0.001, 60},
                        Tier::advanced,
                        "A pose is compared where reference poses lie on both sides of it, no further apart than "
                        "this. A larger value compares more poses, with less certain reference poses."},
      Option<S, double>{"rpe_step",
                        &S::rpe_step,
                        Unit::second,
                        {0.01, 1000},
                        Tier::advanced,
                        "Time between the two poses of a relative pose error."},
      Option<S, double>{"rpe_distance",
                        &S::rpe_distance_m,
                        Unit::metre,
                        {0.01, 10000},
                        Tier::advanced,
                        "Distance travelled between the two poses of a relative pose error by distance."},
      Option<S, double>{"segment",
                        &S::segment_m,
                        Unit::metre,
                        {0.1, 10000},
                        Tier::advanced,
                        "Segments of 1 to 8 times this length give the relative errors of KITTI."},
      Option<S, double>{"loop_radius",
                        &S::loop_radius_m,
                        Unit::metre,
                        {0.1, 100},
                        Tier::advanced,
                        "A loop is right where the reference puts its two places no further apart than this."},
      Option<S, double>{"loop_path",
                        &S::loop_path_m,
                        Unit::metre,
                        {1, 10000},
                        Tier::advanced,
                        "Minimum distance travelled between two visits of a place that count as a chance for a loop."},
      Option<S, double>{"loop_shift",
                        &S::loop_shift_m,
                        Unit::metre,
                        {0.001, 100},
                        Tier::advanced,
                        "Maximum position error of a loop whose relative pose counts as true."},
      Option<S, double>{"loop_turn",
                        &S::loop_turn_deg,
                        Unit::degree,
                        {0.01, 180},
                        Tier::advanced,
                        "Maximum rotation error of a loop whose relative pose counts as true."},
      Option<S, PublishedPlot>{
          "published_plot", &S::published_plot, Tier::advanced,
          "Plot of the improved-LOAM paper whose published figures are listed beside the results."},
      Option<S, std::optional<PaperSystem>>{
          "published_system", &S::published_system, "auto", Tier::advanced,
          "System of the paper whose published figures are listed. auto: that of the preset which made the trajectory, "
          "improved_loam where the paper has none."},
      Unless{"published_plot", {"none"}, {"published_system"}},
  });
  return table;
}

const OptionTable& option_table(const RowMatchOptions*) {
  using S = RowMatchOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"match_distance",
                        &S::match_distance_m,
                        Unit::metre,
                        {0.01, 10},
                        Tier::basic,
                        "Maximum distance between a plant and its reference plant."},
  });
  return table;
}

}  // namespace bole::evaluation
