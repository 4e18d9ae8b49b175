// The options of a measurement, kept with its table so that an edit can repeat it.
#pragma once

#include "cloud/facts.h"
#include "plant/core/traits/traits.h"

namespace bole::plant {

void put_trait_options(Facts& facts, const TraitOptions& options);

// Throws Error{bad_input} where the facts hold none, or damaged ones.
TraitOptions trait_options_of(const Facts& facts);

}  // namespace bole::plant
