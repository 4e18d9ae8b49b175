#include "ground/core/options.h"

namespace bole::ground {
namespace {

void check(const GroundOptions& o) {
  if (o.method == "tin" && o.seed_m < 2 * o.cell_m)
    throw bad_input("seed_m is " + number_text(o.seed_m) + " m and cell_m is " + number_text(o.cell_m) + " m",
                    "seed_m of at least twice cell_m", "Raise seed_m or lower cell_m");
}

}  // namespace

const OptionTable& option_table(const GroundOptions*) {
  using S = GroundOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::string>{"method",
                                 &S::method,
                                 TextKind::choice,
                                 {"tin", "lowest"},
                                 Tier::basic,
                                 "tin: terrain from the ground points; lowest: a level plane at the lowest points, for "
                                 "a tree that was cut out without ground."},
          Option<S, double>{
              "cell_m", &S::cell_m, Unit::metre, {0.02, 10.0}, Tier::basic, "Cell size of the terrain model."},
          Option<S, double>{"seed_m",
                            &S::seed_m,
                            Unit::metre,
                            {0.5, 200.0},
                            Tier::basic,
                            "Cell size in which the lowest point is taken for ground to begin with: larger than the "
                            "largest object that hides the ground (shrub, boulder, building)."},
          Option<S, double>{"max_slope_deg",
                            &S::max_slope_deg,
                            Unit::degree,
                            {5.0, 85.0},
                            Tier::basic,
                            "Steepest terrain to expect; lowest points that rise or fall more steeply than this from "
                            "their neighbours are not taken for ground to begin with."},
          Option<S, double>{"max_angle_deg",
                            &S::max_angle_deg,
                            Unit::degree,
                            {1.0, 60.0},
                            Tier::advanced,
                            "Greatest angle at the nearest ground point by which a further ground point may leave the "
                            "triangulation."},
          Option<S, double>{"max_distance_m",
                            &S::max_distance_m,
                            Unit::metre,
                            {0.02, 10.0},
                            Tier::advanced,
                            "Greatest distance of a further ground point from the triangulation."},
          Option<S, double>{"roughness_m",
                            &S::roughness_m,
                            Unit::metre,
                            {0.0, 2.0},
                            Tier::advanced,
                            "Distance from the triangulation that counts as ground whatever the angle: noise of the "
                            "cloud and micro-relief."},
          Option<S, double>{"band_m",
                            &S::band_m,
                            Unit::metre,
                            {0.05, 5.0},
                            Tier::expert,
                            "Points up to this far above and below the first surface take part in the local fit of the "
                            "terrain height."},
          Option<S, double>{"tolerance_m",
                            &S::tolerance_m,
                            Unit::metre,
                            {0.01, 5.0},
                            Tier::basic,
                            "Points within this height of the terrain model are classified as ground."},
          Option<S, double>{"noise_depth_m",
                            &S::noise_depth_m,
                            Unit::metre,
                            {0.02, 50.0},
                            Tier::advanced,
                            "Points deeper than this below the terrain model are classified as low noise."},
          Option<S, double>{"fill_distance_m",
                            &S::fill_distance_m,
                            Unit::metre,
                            {0.0, 1000.0},
                            Tier::basic,
                            "Cells without ground points are filled up to this far from the nearest cell with ground "
                            "points; beyond it the terrain model has no value."},
          Option<S, bool>{
              "keep_classes", &S::keep_classes, Tier::advanced,
              "Keep classes of the input other than unassigned, ground and low noise (water, building, vegetation)."},
          OnlyIf{"method",
                 {"tin"},
                 {"seed_m", "max_slope_deg", "max_angle_deg", "max_distance_m", "roughness_m", "band_m",
                  "fill_distance_m"}},
      },
      check);
  return table;
}

}  // namespace bole::ground
