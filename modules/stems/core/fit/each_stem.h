// One stem after another, in threads: what goes wrong with one of them is told and harms no other.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// Calls measure(k) for every stem, from any thread. Where it throws, forget(stem) takes back what may be half done and
// the report is warned: "tree 12: `what` is not measured: ...", in the order of the stems. Throws Error{cancelled}
// alone.
void for_each_stem(std::vector<Stem>& stems, std::string_view what, const Run& run, Report& report,
                   const std::function<void(std::size_t k)>& measure, const std::function<void(Stem& stem)>& forget);

}  // namespace bole::stems
