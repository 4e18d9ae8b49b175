// Every stage result explains itself: what came out, how well, how long it took, and what was odd.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/units.h"

namespace bole {
inline namespace base {

enum class Status { ok, finished_early, warning };

struct Metric {
  double value = 0;
  Unit unit = Unit::none;
};

struct Report {
  Status status = Status::ok;
  std::string message;                         // one sentence for a person
  std::map<std::string, std::int64_t> counts;  // "frames", "stems", ...
  std::map<std::string, Metric> metrics;       // residuals and the like
  std::map<std::string, std::string> facts;    // words: {"axes", "plot"}
  std::vector<std::string> warnings;           // partial trouble; never ends the run
  double seconds = 0;                          // wall time, filled by the caller of the stage
  double peak_mib = 0;                         // peak resident memory of the process when the stage ended, likewise

  void warn(std::string text) {
    if (status == Status::ok) status = Status::warning;
    warnings.push_back(std::move(text));
  }
};

}  // namespace base
}  // namespace bole
