// The paper's tuning by trial, on the simulated tractor.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "steering/core/drive_options.h"

namespace bole::steering {

struct Tuning {
  Table steps;       // parameter, value, swing_m: every try
  Table parameters;  // speed_km_h, preview_m, p, i, d and published_*
  Report report;
};

// With P at a middling value the preview distance shrinks in steps of 1 m until the tractor oscillates slightly, and is
// set 1 m above; then P grows in steps of 5 until it oscillates; then D grows from 0 in steps of 1 until it does not;
// last, I grows in steps of 1 while nothing oscillates, up to what brings the wheel to its steady offset within the
// run-in. Noise and disturbances are off, so that only the loop itself can oscillate. Throws Error{failed} when D
// cannot calm it, Error{cancelled}.
Tuning tune(const TuneOptions& options, const Run& run);

}  // namespace bole::steering
