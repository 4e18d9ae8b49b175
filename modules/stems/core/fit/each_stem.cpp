#include "stems/core/fit/each_stem.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <exception>
#include <string>

namespace bole::stems {

void for_each_stem(std::vector<Stem>& stems, std::string_view what, const Run& run, Report& report,
                   const std::function<void(std::size_t k)>& measure, const std::function<void(Stem& stem)>& forget) {
  std::vector<std::string> faults(stems.size());
  tbb::parallel_for(std::size_t{0}, stems.size(), [&](std::size_t k) {
    if (run.cancelled()) return;
    try {
      measure(k);
    } catch (const std::exception& e) {
      forget(stems[k]), faults[k] = e.what();
    }
  });
  run.check_cancel();
  for (std::size_t k = 0; k < stems.size(); ++k)
    if (!faults[k].empty()) report.warn(fmt::format("tree {}: {} is not measured: {}", stems[k].id, what, faults[k]));
}

}  // namespace bole::stems
