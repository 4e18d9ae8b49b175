#include "base/core/path_list.h"
#include "io/core/tiles/cut_cloud.h"

namespace bole::io {

const OptionTable& option_table(const CutOptions*) {
  using S = CutOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"files",
                             &S::files,
                             TextKind::input_path,
                             {path_separator},
                             Tier::basic,
                             "Point cloud to cut: LAS, LAZ or COPC files of one cloud, separated by commas."},
      Option<S, double>{"tile",
                        &S::tile_m,
                        Unit::metre,
                        {1.0, 10000.0},
                        Tier::basic,
                        "Side of the core of a tile. Larger tiles repeat fewer points and take more memory."},
      Option<S, double>{"buffer",
                        &S::buffer_m,
                        Unit::metre,
                        {0.0, 1000.0},
                        Tier::basic,
                        "Width of the strip around a core whose points belong to the tile too. It should be wider than "
                        "a crown."},
      Option<S, double>{"shift_x",
                        &S::shift_x,
                        Unit::metre,
                        {-10000.0, 10000.0},
                        Tier::advanced,
                        "Shift of the grid of tiles to the east. Cores begin at multiples of tile plus this."},
      Option<S, double>{"shift_y",
                        &S::shift_y,
                        Unit::metre,
                        {-10000.0, 10000.0},
                        Tier::advanced,
                        "Shift of the grid of tiles to the north."},
      Option<S, std::optional<double>>{"breast_height",
                                       &S::breast_height,
                                       Unit::metre,
                                       {0.1, 5.0},
                                       "auto",
                                       Tier::advanced,
                                       "Height above ground at which diameters are measured, noted in the tiles. auto: "
                                       "as the files say, else 1.3 m."},
  });
  return table;
}

}  // namespace bole::io
