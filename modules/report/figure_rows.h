// Rows that the option tables of reports share.
#pragma once

#include "base/option.h"

namespace bole::report {

// Of options with a member figure_width in millimetres.
template <class S>
Option<S, double> figure_width_row() {
  return {"figure_width", &S::figure_width, Unit::millimetre, {60, 800}, Tier::basic, "Width of the figures."};
}

// Of options with a member dpi.
template <class S>
Option<S, double> dpi_row() {
  return {"dpi", &S::dpi, Unit::dot_per_inch, {50, 1200}, Tier::basic, "Resolution of the PNG."};
}

}  // namespace bole::report
