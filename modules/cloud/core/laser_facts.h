// Facts about the lasers of a sensor: how well their beam is known, and how many there are.
#pragma once

#include "cloud/known_facts.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo beam_divergence_sd{"beam_divergence_sd_mrad", "mrad", 0, 100,
                                             "Standard deviation of beam_divergence_mrad where the maker states none."};
inline constexpr FactInfo lasers{"lasers", "1", 1, 1e6,
                                 "Number of lasers: the constant range errors of many average out."};

}  // namespace facts
}  // namespace cloud
}  // namespace bole
