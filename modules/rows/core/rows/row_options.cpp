#include "rows/core/rows/row_options.h"

namespace bole::rows {

const OptionTable& option_table(const RowOptions*) {
  using S = RowOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"fit",
                             &S::fit,
                             TextKind::choice,
                             {"least_squares", "orthogonal"},
                             Tier::advanced,
                             "Line of a row: least_squares as in the paper, y = a x + b (x = a y + b for rows that run "
                             "more north than east), or orthogonal, of the distances across the line."},
      Option<S, double>{"plant_spacing",
                        &S::plant_spacing,
                        Unit::metre,
                        {0, 100},
                        Tier::basic,
                        "Distance of plants along the row; 0: found from the plants."},
      Option<S, double>{"row_spacing",
                        &S::row_spacing,
                        Unit::metre,
                        {0, 200},
                        Tier::basic,
                        "Distance of neighbouring rows; 0: found from the plants."},
      Option<S, std::string>{"direction",
                             &S::direction,
                             TextKind::choice,
                             {"auto", "given"},
                             Tier::basic,
                             "Direction in which rows are looked for: found about every plant, or direction_deg."},
      Option<S, double>{"direction_deg",
                        &S::direction_deg,
                        Unit::degree,
                        {-180, 180},
                        Tier::basic,
                        "Direction of the rows from east to north; needed only for plantings as wide along the row "
                        "as across."},
      Option<S, int>{"gap_max",
                     &S::gap_max,
                     Unit::none,
                     {0, 100},
                     Tier::basic,
                     "Most plants missing one after the other within a row; beyond that another row begins."},
      Option<S, int>{"plants_min",
                     &S::plants_min,
                     Unit::none,
                     {2, 1000},
                     Tier::basic,
                     "Fewest plants of a row that is found; rows named by a row_id column may be shorter."},
      Option<S, double>{"lateral_tolerance",
                        &S::lateral_tolerance,
                        Unit::none,
                        {0.05, 0.9},
                        Tier::advanced,
                        "How far the next plant may lie beside the row's line, as a share of the plant spacing (and at "
                        "most of the row spacing)."},
      Option<S, std::string>{"shape",
                             &S::shape,
                             TextKind::choice,
                             {"auto", "straight"},
                             Tier::advanced,
                             "auto: rows that are clearly curved get a curve; straight: every row is a line."},
      OnlyIf{"direction", {"given"}, {"direction_deg"}},
  });
  return table;
}

}  // namespace bole::rows
