#include "plant/core/surface/region.h"
#include "plant/core/surface/tsdf.h"

namespace bole::plant {

const OptionTable& option_table(const FuseOptions*) {
  using S = FuseOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, double>{"voxel",
                            &S::voxel,
                            Unit::metre,
                            {0.0002, 0.5},
                            Tier::basic,
                            "Edge length of the voxels. Smaller voxels keep thinner parts and need more memory."},
          Option<S, std::string>{"region",
                                 &S::region,
                                 TextKind::plain,
                                 {},
                                 Tier::basic,
                                 "Box in world axes: min x, y, z, max x, y, z in metres. Empty: found from the views."},
          Option<S, bool>{"mesh", &S::mesh, Tier::basic, "Also make a mesh: outputs vertices and triangles."},
          Option<S, std::optional<double>>{
              "truncation",
              &S::truncation,
              Unit::metre,
              {0.0005, 1},
              "auto",
              Tier::advanced,
              "How far from a measured depth the distance is recorded. A larger value closes gaps and thickens thin "
              "parts. auto: 4 voxels, or 1.5 standard deviations of the depth."},
          Option<S, double>{"depth_sigma",
                            &S::depth_sigma,
                            Unit::metre,
                            {1e-5, 0.1},
                            Tier::advanced,
                            "Standard deviation of a depth at 0.5 m. It grows with the square of the distance."},
          Option<S, double>{"min_weight",
                            &S::min_weight,
                            Unit::none,
                            {0, 1000},
                            Tier::advanced,
                            "Weight that a surface needs: 1 is one straight view from 0.5 m. A larger value removes "
                            "parts that few views saw."},
          Option<S, double>{"min_share",
                            &S::min_share,
                            Unit::none,
                            {0.05, 1},
                            Tier::advanced,
                            "Share of the views that must see a place for it to be in the region."},
          Option<S, int>{"max_memory",
                         &S::max_memory_mib,
                         Unit::mebibyte,
                         {16, 65536},
                         Tier::expert,
                         "Memory for voxels. Larger voxels are used where this is not enough."},
      },
      [](const S& s) { region_from_text(s.region); });
  return table;
}

}  // namespace bole::plant
