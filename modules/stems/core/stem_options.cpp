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
          "Breast height above ground: the middle of the slice, and the height at which diameters are measured."},
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
                            "Thinner stems are listed as rejected."},
          Option<S, double>{"max_dbh",
                            &S::max_dbh_cm,
                            Unit::centimetre,
                            {10, 500},
                            Tier::basic,
                            "Thicker stems are not searched for."},
          Option<S, double>{"search_bottom",
                            &S::search_bottom,
                            Unit::metre,
                            {0.1, 5.0},
                            Tier::advanced,
                            "Lowest height above ground at which stems are searched for. Raise it above shrubs."},
          Option<S, double>{"search_top",
                            &S::search_top,
                            Unit::metre,
                            {0.5, 20.0},
                            Tier::advanced,
                            "Greatest height above ground at which stems are searched for. Keep it below the crowns."},
          Option<S, double>{"max_lean",
                            &S::max_lean_deg,
                            Unit::degree,
                            {5, 60},
                            Tier::advanced,
                            "Greatest lean of a stem from the vertical."},
          Option<S, int>{"min_sections",
                         &S::min_sections,
                         Unit::none,
                         {2, 20},
                         Tier::advanced,
                         "A stem must show a circle at this many heights. A larger value rejects more bushes, but also "
                         "more hidden stems."},
          Option<S, int>{"min_section_points",
                         &S::min_section_points,
                         Unit::none,
                         {4, 1000},
                         Tier::advanced,
                         "Fewest points on the bark of a section that is used."},
          Option<S, double>{"min_arc",
                            &S::min_arc_deg,
                            Unit::degree,
                            {30, 300},
                            Tier::advanced,
                            "Smallest part of the circle that must be seen in a section that is used."},
          Option<S, BreastHeightFrom>{"breast_height_from", &S::breast_height_from, Tier::basic,
                                      "Ground from which breast height is measured: the highest ground at the stem "
                                      "base, or the mean of the ground around it."},
          Option<S, FitModel>{"model", &S::model, Tier::advanced,
                              "Residual of the joint fit. ray: error along the ray of a beam of finite width, needs "
                              "sensor positions; surface: distance from the bark; auto: ray where sensor positions "
                              "are known."},
          Option<S, double>{"window",
                            &S::window,
                            Unit::metre,
                            {0.1, 3.0},
                            Tier::advanced,
                            "Sections up to this far above and below breast height take part in the joint fit."},
          Option<S, double>{"section_step",
                            &S::section_step,
                            Unit::metre,
                            {0.02, 1.0},
                            Tier::advanced,
                            "Spacing and thickness of the sections."},
          Option<S, double>{"max_sigma",
                            &S::max_sigma,
                            Unit::metre,
                            {0.002, 0.10},
                            Tier::expert,
                            "Upper limit of the robust scale of the residuals, so that outliers cannot swell the stem. "
                            "It is raised to 1.25 times the range noise of a noisier sensor."},
          Option<S, double>{
              "ray_gate",
              &S::ray_gate,
              Unit::none,
              {0.5, 0.99},
              Tier::expert,
              "The ray model leaves out rays that pass the stem axis further away than this share of the radius."},
          Option<S, std::optional<double>>{
              "beam_divergence",
              &S::beam_divergence_mrad,
              Unit::none,
              {0, 20},
              "cloud",
              Tier::expert,
              "Horizontal full angle of the beam (1/e^2) in milliradians; cloud: as the cloud says. A wide beam "
              "measures the mean of the round bark that it lights."},
          Option<S, std::optional<double>>{
              "beam_divergence_sd",
              &S::beam_divergence_sd_mrad,
              Unit::none,
              {0, 20},
              "cloud",
              Tier::expert,
              "Standard deviation of beam_divergence in milliradians; cloud: 0 where the maker of the sensor states "
              "its beam, 1 where it is that of a similar sensor, 1.5 where none is known. A larger value widens the "
              "intervals."},
          Option<S, std::optional<double>>{
              "beam_aperture",
              &S::beam_aperture,
              Unit::metre,
              {0, 0.1},
              "cloud",
              Tier::expert,
              "Horizontal width of the beam where it leaves the sensor; cloud: as the cloud says."},
          Option<S, std::optional<double>>{
              "range_noise",
              &S::range_noise,
              Unit::metre,
              {0, 1},
              "cloud",
              Tier::expert,
              "Standard deviation of a single range; cloud: as the cloud says. It raises max_sigma for noisy "
              "sensors."},
          Option<S, std::string>{"bark",
                                 &S::bark,
                                 TextKind::input_path_or_name,
                                 {},
                                 Tier::basic,
                                 "Bark of the stand, which the points do not show: mean adds nothing (a convention); "
                                 "smooth (beech), scaly "
                                 "(spruce), ridged (ash), plated (pine) and furrowed (oak) add what a tape over the "
                                 "ridges reads more, with "
                                 "wider intervals. Or the path of a JSON file."},
          Option<S, std::optional<double>>{
              "bark_relief",
              &S::bark_relief,
              Unit::metre,
              {0, 0.03},
              "bark",
              Tier::advanced,
              "Mean depth of the bark fissures below the ridges on which a tape lies; the ray model adds it to the "
              "radius. bark: as the option bark says."},
          Option<S, std::optional<double>>{"bark_relief_sd",
                                           &S::bark_relief_sd,
                                           Unit::metre,
                                           {0, 0.03},
                                           "bark",
                                           Tier::advanced,
                                           "Standard deviation of bark_relief, which the intervals allow for. bark: as "
                                           "the option bark says."},
          Option<S, bool>{"estimate_range_offset", &S::estimate_range_offset, Tier::expert,
                          "Estimate the mean range error from all stems and remove it. It comes from the lasers, or "
                          "from poses that lie too close to the stems."},
          Option<S, std::optional<double>>{
              "range_offset_sd",
              &S::range_offset_sd,
              Unit::metre,
              {0.0001, 0.05},
              "cloud",
              Tier::expert,
              "Standard deviation of the range offset of calibrated sensors; cloud: 0.4 mm for 32 lasers or more, more "
              "for fewer (1.1 mm for four). The estimate is regularised towards zero with it; a larger value follows "
              "the stems more closely and widens the intervals."},
          Option<S, double>{"range_bias",
                            &S::range_bias,
                            Unit::metre,
                            {0, 0.05},
                            Tier::expert,
                            "Standard deviation of the range error that all points of a stem share. A larger value "
                            "widens the intervals."},
          Option<S, double>{"pass_gap",
                            &S::pass_gap,
                            Unit::second,
                            {0.5, 600},
                            Tier::advanced,
                            "A pause of this length between returns from a stem starts a new pass of the walk."},
          Option<S, double>{
              "max_range",
              &S::max_range,
              Unit::metre,
              {1, 300},
              Tier::advanced,
              "The fits leave out returns from further away where ranges are known and enough nearer returns exist."},
          Option<S, double>{
              "max_ray_through",
              &S::max_ray_through,
              Unit::none,
              {0.01, 1},
              Tier::advanced,
              "A candidate is rejected when more than this share of the rays towards its core pass through it."},
          Option<S, double>{"crown_radius",
                            &S::crown_radius,
                            Unit::metre,
                            {0.2, 20},
                            Tier::basic,
                            "Points further from every stem axis than this belong to no tree."},
          Option<S, double>{"bark_tolerance",
                            &S::bark_tolerance,
                            Unit::metre,
                            {0.005, 0.2},
                            Tier::advanced,
                            "Points closer to the fitted surface than this are marked as bark."},
          OnlyIf{"model",
                 {"auto", "ray"},
                 {"ray_gate", "beam_divergence", "beam_divergence_sd", "beam_aperture", "bark", "bark_relief",
                  "bark_relief_sd", "estimate_range_offset"}},
          OnlyIf{"estimate_range_offset", {"true"}, {"range_offset_sd"}},
      },
      [](const S& s) {
        if (s.search_top < s.search_bottom + 0.5)
          throw bad_input("options search_bottom " + number_text(s.search_bottom) + " m and search_top " +
                              number_text(s.search_top) + " m",
                          "at least 0.5 m between them");
        if (s.max_dbh_cm <= s.min_dbh_cm)
          throw bad_input(
              "options min_dbh " + number_text(s.min_dbh_cm) + " cm and max_dbh " + number_text(s.max_dbh_cm) + " cm",
              "max_dbh above min_dbh");
      });
  return table;
}

}  // namespace bole::stems
