#include "base/error.h"
#include "steering/core/plan/plan_lines.h"

namespace bole::steering {

const OptionTable& option_table(const PlanOptions*) {
  using S = PlanOptions;
  using Number = Option<S, double>;
  using Count = Option<S, int>;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::optional<double>>{"width",
                                           &S::width,
                                           Unit::metre,
                                           {0.1, 100},
                                           "none",
                                           Tier::basic,
                                           "Width of the implement. none: only the line through A and B."},
          Number{"overlap",
                 &S::overlap,
                 Unit::metre,
                 {-10, 50},
                 Tier::basic,
                 "Width that neighbouring passes share. Negative: a gap between them."},
          Count{"lines_left",
                &S::lines_left,
                Unit::none,
                {0, 10000},
                Tier::basic,
                "Lines to the left of A and B, where no boundary is given."},
          Count{"lines_right",
                &S::lines_right,
                Unit::none,
                {0, 10000},
                Tier::basic,
                "Lines to the right of A and B, where no boundary is given."},
          Count{"headland_passes",
                &S::headland_passes,
                Unit::none,
                {0, 100},
                Tier::basic,
                "Width of the headland, in passes of the implement."},
          Number{"min_length",
                 &S::min_length,
                 Unit::metre,
                 {0, 1000},
                 Tier::advanced,
                 "Shorter pieces of lines within a boundary are left out."},
          Unless{"width", {"none"}, {"overlap", "lines_left", "lines_right", "headland_passes"}},
      },
      [](const S& o) {
        if (o.width && !(o.overlap < *o.width))
          throw bad_input(
              "an overlap of " + number_text(o.overlap) + " m and a width of " + number_text(*o.width) + " m",
              "an overlap below the width");
      });
  return table;
}

}  // namespace bole::steering
