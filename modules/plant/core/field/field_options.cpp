#include "plant/core/field/field_options.h"

#include "plant/core/surface/region.h"

namespace bole::plant {

const OptionTable& option_table(const FieldOptions*) {
  using S = FieldOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, EncoderKind>{"encoder", &S::encoder, Tier::basic,
                                 "What holds density and colour: grid is a voxel lattice, hash a multiresolution hash "
                                 "table with a small network, paper a network alone (slow)."},
          Option<S, double>{"voxel", &S::voxel, Unit::metre, {0.0002, 1}, Tier::basic,
                            "Finest detail of the field. Smaller values keep thinner parts and need more memory and "
                            "time."},
          Option<S, std::string>{"region", &S::region, TextKind::plain, {}, Tier::basic,
                                 "Box in world axes: min x, y, z, max x, y, z in metres. Empty: found from the views."},
          Option<S, Background>{"background", &S::background, Tier::basic,
                                "What is behind the plant: a scene, or white or black in pictures of an object alone."},
          Option<S, double>{"max_seconds", &S::max_seconds, Unit::second, {1, 1e6}, Tier::basic,
                            "Time for the training. It is ended, with its schedule, when this is used up before "
                            "steps are done."},
          Option<S, int>{"steps", &S::steps, Unit::none, {1, 1'000'000}, Tier::basic,
                         "Steps of the training. More steps give a sharper field."},
          Option<S, int>{"rays", &S::rays, Unit::none, {64, 1'000'000}, Tier::advanced, "Rays of each step."},
          Option<S, int>{"max_width", &S::max_width, Unit::pixel, {16, 10000}, Tier::advanced,
                         "Pictures much wider than this are made smaller by a whole number. Larger pictures show finer "
                         "detail and need more steps."},
          Option<S, int>{"hold_out", &S::hold_out, Unit::none, {0, 1000}, Tier::advanced,
                         "Every n-th view is kept back to test the field, unless the data say which; 0 keeps none."},
          Option<S, bool>{"exposure", &S::exposure, Tier::advanced,
                          "Estimate the exposure of each view, for cameras that set it by themselves."},
          Option<S, double>{"depth_weight", &S::depth_weight, Unit::none, {0, 10}, Tier::advanced,
                            "Weight of measured depth beside colour. 0 uses colour alone."},
          Option<S, double>{"depth_sigma", &S::depth_sigma, Unit::metre, {1e-5, 0.1}, Tier::advanced,
                            "Standard deviation of a depth at 0.5 m. It grows with the square of the distance."},
          Option<S, double>{"min_share", &S::min_share, Unit::none, {0.05, 1}, Tier::advanced,
                            "Share of the views that must see a place for it to be in the region."},
          Option<S, double>{"cloud_spacing", &S::cloud_spacing, Unit::metre, {0, 1}, Tier::advanced,
                            "Spacing of the points of the cloud. 0 keeps all."},
          Option<S, int>{"cloud_min_views", &S::cloud_min_views, Unit::none, {1, 1000}, Tier::advanced,
                         "Views that must agree on a point of the cloud. A larger value removes more stray points."},
          Option<S, double>{"cloud_tolerance", &S::cloud_tolerance, Unit::metre, {1e-5, 1}, Tier::advanced,
                            "Largest difference of depths that agree."},
          Option<S, int>{"max_memory", &S::max_memory_mib, Unit::mebibyte, {64, 65536}, Tier::expert,
                         "Memory for the field. Larger voxels are used where this is not enough."},
          Option<S, int>{"seed", &S::seed, Unit::none, {0, 1'000'000'000}, Tier::expert,
                         "Seed of the random choice of rays. The same seed gives the same field."},
      },
      [](const S& s) { region_from_text(s.region); });
  return table;
}

}  // namespace bole::plant
