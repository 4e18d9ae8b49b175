#include "stems/core/stem_options.h"

namespace bole::stems {

const OptionTable& option_table(const SliceOptions*) {
  using S = SliceOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{
          "height",
          &S::height,
          Unit::metre,
          {0.1, 5.0},
          Tier::basic,
          "Breast height: the middle of the slice above ground, and the height that diameters are measured at."},
      Option<S, double>{"thickness", &S::thickness, Unit::metre, {0.01, 1.0}, Tier::basic, "Thickness of the slice."},
  });
  return table;
}

const OptionTable& option_table(const MeasureOptions*) {
  using S = MeasureOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, double>{"min_dbh",
                            &S::min_dbh_cm,
                            Unit::centimetre,
                            {2, 100},
                            Tier::basic,
                            "Stems thinner than this at breast height are listed as rejected."},
          Option<S, double>{"max_dbh",
                            &S::max_dbh_cm,
                            Unit::centimetre,
                            {10, 500},
                            Tier::basic,
                            "Stems thicker than this at breast height are not searched for."},
          Option<S, double>{"search_bottom",
                            &S::search_bottom_m,
                            Unit::metre,
                            {0.1, 5.0},
                            Tier::advanced,
                            "Stems are searched for from this height above ground."},
          Option<S, double>{"search_top",
                            &S::search_top_m,
                            Unit::metre,
                            {0.5, 20.0},
                            Tier::advanced,
                            "Stems are searched for up to this height above ground: above shrubs, below the crowns."},
          Option<S, double>{"max_lean",
                            &S::max_lean_deg,
                            Unit::degree,
                            {5, 60},
                            Tier::advanced,
                            "A stem may lean by this much from the vertical."},
          Option<S, int>{"min_sections",
                         &S::min_sections,
                         Unit::none,
                         {2, 20},
                         Tier::advanced,
                         "A stem must be seen as a circle at this many heights."},
          Option<S, int>{"min_section_points",
                         &S::min_section_points,
                         Unit::none,
                         {4, 1000},
                         Tier::advanced,
                         "A section is used when it has at least this many points on the bark."},
          Option<S, double>{"min_arc",
                            &S::min_arc_deg,
                            Unit::degree,
                            {30, 300},
                            Tier::advanced,
                            "A section is used when at least this much of its circle is seen."},
          Option<S, std::string>{"breast_height_from",
                                 &S::breast_height_from,
                                 TextKind::choice,
                                 {"uphill", "mean"},
                                 Tier::basic,
                                 "Breast height is counted from the highest ground at the stem base, or from the mean "
                                 "of the ground around it."},
          Option<S, std::string>{
              "model",
              &S::model,
              TextKind::choice,
              {"auto", "ray", "surface"},
              Tier::advanced,
              "Residual of the joint fit: ray is the error along the ray with a beam of finite width, which needs "
              "sensor "
              "positions; surface is the distance to the bark; auto takes ray where sensor positions are known."},
          Option<S, double>{"window",
                            &S::window_m,
                            Unit::metre,
                            {0.1, 3.0},
                            Tier::advanced,
                            "The joint fit uses sections up to this far above and below breast height."},
          Option<S, double>{"section_step",
                            &S::section_step_m,
                            Unit::metre,
                            {0.02, 1.0},
                            Tier::advanced,
                            "Spacing and thickness of the sections."},
          Option<S, double>{"max_sigma",
                            &S::max_sigma_m,
                            Unit::metre,
                            {0.002, 0.10},
                            Tier::expert,
                            "Cap of the robust scale of the residuals, so that outliers cannot swell the stem."},
          Option<S, double>{
              "ray_gate",
              &S::ray_gate,
              Unit::none,
              {0.5, 0.99},
              Tier::expert,
              "Rays that pass the stem axis further away than this share of the radius are left out of the ray model."},
          Option<S, double>{"beam_divergence",
                            &S::beam_divergence_mrad,
                            Unit::none,
                            {0, 20},
                            Tier::expert,
                            "Horizontal full angle of the beam (1/e^2) in milliradians: a wide beam "
                            "measures the mean of the round bark that it lights."},
          Option<S, double>{"beam_aperture",
                            &S::beam_aperture_m,
                            Unit::metre,
                            {0, 0.1},
                            Tier::expert,
                            "Horizontal width of the beam where it leaves the sensor."},
          Option<S, double>{
              "bark_relief",
              &S::bark_relief_m,
              Unit::metre,
              {0, 0.03},
              Tier::advanced,
              "Mean depth of the bark below the ridges that a tape lies on; the ray model, which sees the "
              "fissures too, adds it to the radius. Smooth bark 0, medium bark 1 mm, pine or oak more."},
          Option<S, bool>{
              "estimate_range_offset", &S::estimate_range_offset, Tier::expert,
              "Estimate over all stems what the rays measure too far on average, by lasers or by poses that "
              "lean towards the stems, and take it out."},
          Option<S, double>{"range_offset_sd",
                            &S::range_offset_sd_m,
                            Unit::metre,
                            {0.0001, 0.05},
                            Tier::expert,
                            "Range offset expected of a calibrated sensor, a standard deviation: where the stems say "
                            "little about the offset, it is drawn to zero by this."},
          Option<S, double>{"range_bias",
                            &S::range_bias_m,
                            Unit::metre,
                            {0, 0.05},
                            Tier::expert,
                            "Standard deviation of what the sensor measures too far or too near on all of a stem "
                            "alike, bark fissures included: it widens the intervals."},
          Option<S, double>{"pass_gap",
                            &S::pass_gap_s,
                            Unit::second,
                            {0.5, 600},
                            Tier::advanced,
                            "A pause of this length in the returns of a stem begins a new pass of the walk."},
          Option<S, double>{
              "max_range",
              &S::max_range_m,
              Unit::metre,
              {1, 300},
              Tier::advanced,
              "Returns from further away are left out of the fits where the range is known and nearer ones suffice."},
          Option<S, double>{
              "max_ray_through",
              &S::max_ray_through,
              Unit::none,
              {0.01, 1},
              Tier::advanced,
              "A candidate is rejected when more than this share of the rays towards its core pass through it."},
          Option<S, double>{"crown_radius",
                            &S::crown_radius_m,
                            Unit::metre,
                            {0.2, 20},
                            Tier::basic,
                            "Points further than this from every stem axis belong to no tree."},
          Option<S, double>{"bark_tolerance",
                            &S::bark_tolerance_m,
                            Unit::metre,
                            {0.005, 0.2},
                            Tier::advanced,
                            "Points nearer than this to the fitted surface are marked as bark."},
          OnlyIf{"model",
                 {"auto", "ray"},
                 {"ray_gate", "beam_divergence", "beam_aperture", "bark_relief", "estimate_range_offset"}},
          OnlyIf{"estimate_range_offset", {"true"}, {"range_offset_sd"}},
      },
      [](const S& s) {
        if (s.search_top_m < s.search_bottom_m + 0.5)
          throw bad_input("options search_bottom " + number_text(s.search_bottom_m) + " m and search_top " +
                              number_text(s.search_top_m) + " m",
                          "at least 0.5 m between them");
        if (s.max_dbh_cm <= s.min_dbh_cm)
          throw bad_input(
              "options min_dbh " + number_text(s.min_dbh_cm) + " cm and max_dbh " + number_text(s.max_dbh_cm) + " cm",
              "max_dbh above min_dbh");
      });
  return table;
}

}  // namespace bole::stems
