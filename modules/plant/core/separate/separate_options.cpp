#include "plant/core/separate/separate.h"

namespace bole::plant {

const OptionTable& option_table(const SeparateOptions*) {
  using S = SeparateOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, UpChoice>{"up", &S::up, Tier::basic,
                          "Direction that is up. auto takes z where the axes come from a board, else the direction out "
                          "of the largest plane (table, mat or soil), else z."},
      Option<S, ScaleChoice>{"scale", &S::scale, Tier::basic,
                             "Unit of the cloud. auto: metres where a board, given poses or a depth camera fixed the "
                             "scale, else unknown; traits are then in thousandths of the unit and flagged."},
      Option<S, std::string>{"box",
                             &S::box,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Box that is kept: min_x min_y min_z max_x max_y max_z in the axes of the cloud. Points "
                             "outside of it become other."},
      Option<S, std::string>{"base",
                             &S::base,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Place where the stem leaves the soil: x y z in the axes of the cloud. Empty: it is found "
                             "from the points."},
      Option<S, double>{"max_gap",
                        &S::max_gap,
                        Unit::metre,
                        {0, 0.5},
                        Tier::advanced,
                        "Widest gap across which a part of the cloud still belongs to the plant. Larger values keep "
                        "leaves whose stalks were not reconstructed, and floaters near the plant."},
      Option<S, double>{"tolerance",
                        &S::tolerance,
                        Unit::metre,
                        {0.0001, 0.05},
                        Tier::advanced,
                        "Distance from the surfaces of pot, soil and mat within which points belong to them. Raised "
                        "by itself where the cloud is coarser."},
      Option<S, bool>{"drop_floaters", &S::drop_floaters, Tier::basic,
                      "Removes floaters from the output instead of marking them."},
  });
  return table;
}

}  // namespace bole::plant
