// What the stage inventory.plot_values can be told.
#pragma once

#include "base/option.h"
#include "inventory/core/stand_values.h"

namespace bole::inventory {

struct PlotValueOptions {
  double class_width_cm = 4;
  double form_sd_pct = usual_form_sd_pct;
};

const OptionTable& option_table(const PlotValueOptions*);

}  // namespace bole::inventory
