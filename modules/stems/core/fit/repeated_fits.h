// Fits of several candidates that found one stem.
#pragma once

#include <functional>
#include <vector>

#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

struct RepeatedFit {
  Stem stem;
  std::size_t better = 0;  // place of the fit of the better candidate among those that were left
};

// Takes out of `fitted`, best first, what found the stem of a better candidate that is not hopeless.
std::vector<RepeatedFit> take_repeated(std::vector<Stem>& fitted, const std::function<bool(const Stem&)>& hopeless);

// The best of those whose better fit is no stem after all.
std::vector<Stem> restored_fits(const std::vector<RepeatedFit>& repeated,
                                const std::function<bool(std::size_t)>& is_stem);

}  // namespace bole::stems
