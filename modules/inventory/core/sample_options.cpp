#include "inventory/core/sample_plots.h"

namespace bole::inventory {

const OptionTable& option_table(const SampleOptions*) {
  using S = SampleOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"radii",
                             &S::radii,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Radii of the sample plots in metres, for instance \"5 10 15\"."},
      Option<S, int>{"plots",
                     &S::plots,
                     Unit::none,
                     {2, 1'000'000},
                     Tier::basic,
                     "Number of sample plots of each size. More plots give steadier means."},
      Option<S, int>{"seed",
                     &S::seed,
                     Unit::none,
                     {0, 2'000'000'000},
                     Tier::basic,
                     "Seed of the places of the plots. The same seed gives the same plots."},
      Option<S, double>{
          "distance_bias",
          &S::distance_bias,
          Unit::metre,
          {-5, 5},
          Tier::advanced,
          "Constant error of the distance from the centre of a plot to a tree. Negative: trees beyond the "
          "boundary count."},
      Option<S, double>{"distance_sd",
                        &S::distance_sd,
                        Unit::metre,
                        {0, 5},
                        Tier::advanced,
                        "Standard deviation of the error of this distance from tree to tree."},
  });
  return table;
}

}  // namespace bole::inventory
