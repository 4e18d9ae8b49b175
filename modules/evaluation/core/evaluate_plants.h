// Traits of plants beside manual values.
#pragma once

#include "cloud/table.h"

namespace bole::evaluation {

struct PlantEvaluation {
  Table summary;  // measure, value, unit, published
  Table plants;   // plant_id, trait, value, reference, error, relative_error_percent, in_interval (yes, no, empty)
};

// Plants match by plant_id; two tables of one plant each match whatever its name. Compared is every column of numbers
// that both tables have, intervals (NAME_lo_UNIT, NAME_hi_UNIT) apart. Per trait: plants; accuracy, 100 % less the mean
// of |error| / reference (the measure of SPEC C, beside its published figures); bias and RMSE in the unit of the
// column; R2, the square of the correlation, from three plants on; and the share of the estimate's intervals that hold
// the reference. A missing value, or a reference of zero, takes no part in its trait. Throws Error{bad_input} where no
// plant or no trait is in both tables, and for a plant_id that a table has twice.
PlantEvaluation evaluate_plants(const Table& estimate, const Table& reference);

}  // namespace bole::evaluation
