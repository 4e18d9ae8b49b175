#include "inventory/core/inventory_options.h"

namespace bole::inventory {

const OptionTable& option_table(const PlotValueOptions*) {
  using S = PlotValueOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"class_width",
                        &S::class_width_cm,
                        Unit::centimetre,
                        {0.5, 50},
                        Tier::advanced,
                        "Width of the diameter classes in tables and charts."},
      Option<S, double>{"form_sd",
                        &S::form_sd_pct,
                        Unit::percent,
                        {0, 50},
                        Tier::advanced,
                        "Standard deviation of the stem form, shared by all stems whose volume comes from diameter and "
                        "height. A larger value widens the interval of the volume."},
  });
  return table;
}

}  // namespace bole::inventory
