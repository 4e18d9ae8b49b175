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

// What a finding means for the survey: good to know; look at it before you sign; do not use the result.
enum class Severity { note, look, refused };

// Something about the data or the result that a person who signs must know.
struct Finding {
  std::string code;  // for programs: "terrain_filled_under_stems"; stays the same from version to version
  Severity severity = Severity::note;
  std::string text;  // what was found, the number that matters, what to do
};

struct Report {
  Status status = Status::ok;
  std::string message;                         // one sentence for a person
  std::map<std::string, std::int64_t> counts;  // "frames", "stems", ...
  std::map<std::string, Metric> metrics;       // residuals and the like
  std::map<std::string, std::string> facts;    // words: {"axes", "plot"}
  std::vector<std::string> warnings;           // partial trouble; never ends the run
  std::vector<Finding> findings;               // what decides the verdict of the run (base/verdict.h)
  double seconds = 0;                          // wall time, filled by the caller of the stage
  double peak_mib = 0;                         // peak resident memory of the process when the stage ended, likewise

  void warn(std::string text) {
    if (status == Status::ok) status = Status::warning;
    warnings.push_back(std::move(text));
  }

  // A finding is a warning too, so that it is shown wherever warnings are.
  void find(Severity severity, std::string code, std::string text) {
    warn(text);
    findings.push_back({std::move(code), severity, std::move(text)});
  }
};

}  // namespace base
}  // namespace bole
