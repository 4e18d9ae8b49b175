#include "ground/core/options.h"

namespace bole::ground {

const OptionTable& option_table(const GroundOptions*) {
  using S = GroundOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<GroundMethod>>{
          "method", &S::method, "auto", Tier::basic,
          "tin: terrain from the ground points; lowest: a level plane at the lowest points, for a tree that was cut "
          "out without ground; normalised: z is the height above ground already. auto: normalised where that is "
          "certain, else tin."},
      Option<S, std::optional<double>>{"cell",
                                       &S::cell,
                                       Unit::metre,
                                       {0.02, 10.0},
                                       "auto",
                                       Tier::basic,
                                       "Cell size of the terrain model. auto: 0.25 m, more for sparse clouds; whatever "
                                       "else is auto follows the density likewise."},
      Option<S, std::optional<double>>{
          "seed",
          &S::seed,
          Unit::metre,
          {0.5, 200.0},
          "auto",
          Tier::basic,
          "Cell size in which the lowest point starts the ground. Make it larger than the largest "
          "object that hides the ground (shrub, boulder, building)."},
      Option<S, double>{"max_slope",
                        &S::max_slope_deg,
                        Unit::degree,
                        {5.0, 85.0},
                        Tier::basic,
                        "Steepest terrain to expect. Lowest points that lie steeper than this to their neighbours "
                        "do not start the ground."},
      Option<S, std::optional<double>>{
          "max_angle",
          &S::max_angle_deg,
          Unit::degree,
          {1.0, 60.0},
          "auto",
          Tier::advanced,
          "Greatest angle, seen from the nearest ground point, at which a further ground point may "
          "leave the triangulation."},
      Option<S, std::optional<double>>{"max_distance",
                                       &S::max_distance,
                                       Unit::metre,
                                       {0.02, 10.0},
                                       "auto",
                                       Tier::advanced,
                                       "Greatest distance of a further ground point from the triangulation."},
      Option<S, std::optional<double>>{
          "roughness",
          &S::roughness,
          Unit::metre,
          {0.0, 2.0},
          "auto",
          Tier::advanced,
          "Points this close to the triangulation are ground at any angle: noise of the cloud and micro-relief."},
      Option<S, std::optional<double>>{
          "band",
          &S::band,
          Unit::metre,
          {0.05, 5.0},
          "auto",
          Tier::expert,
          "Points up to this far above and below the first surface take part in the local fit of the "
          "terrain height."},
      Option<S, std::optional<double>>{"tolerance",
                                       &S::tolerance,
                                       Unit::metre,
                                       {0.01, 5.0},
                                       "auto",
                                       Tier::basic,
                                       "Points within this height of the terrain model are classified as ground."},
      Option<S, std::optional<double>>{"noise_depth",
                                       &S::noise_depth,
                                       Unit::metre,
                                       {0.02, 50.0},
                                       "auto",
                                       Tier::advanced,
                                       "Points deeper than this below the terrain model are classified as low noise."},
      Option<S, std::optional<double>>{
          "fill_distance",
          &S::fill_distance,
          Unit::metre,
          {0.0, 1000.0},
          "auto",
          Tier::basic,
          "Cells without ground points are filled up to this far from the nearest cell with ground "
          "points. Beyond it the terrain model has no value."},
      Option<S, bool>{
          "keep_classes", &S::keep_classes, Tier::advanced,
          "Keep classes of the input other than unassigned, ground and low noise (water, building, vegetation)."},
      OnlyIf{"method",
             {"auto", "tin"},
             {"seed", "max_slope", "max_angle", "max_distance", "roughness", "band", "fill_distance"}},
  });
  return table;
}

}  // namespace bole::ground
