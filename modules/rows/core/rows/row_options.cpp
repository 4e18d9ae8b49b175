#include "rows/core/rows/row_options.h"

namespace bole::rows {

const OptionTable& option_table(const RowOptions*) {
  using S = RowOptions;
  using OpenNumber = Option<S, std::optional<double>>;
  static const OptionTable table = make_option_table<S>({
      Option<S, LineFitMethod>{"fit", &S::fit, Tier::advanced,
                               "Line fit of a row. least_squares, as in the paper: y = a x + b, or x = a y + b for "
                               "rows that run more north than east; orthogonal: smallest distances across the line."},
      OpenNumber{"plant_spacing",
                 &S::plant_spacing,
                 Unit::metre,
                 {1e-3, 100},
                 "auto",
                 Tier::basic,
                 "Distance between plants along the row. auto: found from the plants."},
      OpenNumber{"row_spacing",
                 &S::row_spacing,
                 Unit::metre,
                 {1e-3, 200},
                 "auto",
                 Tier::basic,
                 "Distance between neighbouring rows. auto: found from the plants."},
      OpenNumber{
          "direction",
          &S::direction_deg,
          Unit::degree,
          {-180, 180},
          "auto",
          Tier::basic,
          "Direction of the rows, from east to north. auto: found around every plant; give it where plants are as "
          "far apart along the row as across."},
      Option<S, int>{"max_gap",
                     &S::max_gap,
                     Unit::none,
                     {0, 100},
                     Tier::basic,
                     "Largest number of consecutive missing plants within a row. A longer gap ends the row."},
      Option<S, int>{"min_plants",
                     &S::min_plants,
                     Unit::none,
                     {2, 1000},
                     Tier::basic,
                     "Smallest number of plants in a row that is found. Rows named by a row_id column may be shorter."},
      Option<S, double>{"lateral_tolerance",
                        &S::lateral_tolerance,
                        Unit::none,
                        {0.05, 0.9},
                        Tier::advanced,
                        "Largest distance of the next plant from the line of its row, as a share of the plant spacing "
                        "and of the row spacing. A larger value follows less regular rows."},
      Option<S, RowShape>{"shape", &S::shape, Tier::advanced,
                          "auto: a clearly curved row gets a curve; straight: every row is a line."},
  });
  return table;
}

}  // namespace bole::rows
