// Whether the result of a run may be signed, and why not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/run.h"

namespace bole {
inline namespace base {

enum class Verdict { sign, look, refused };

struct StageFinding {
  std::string stage;  // its id in the pipeline
  Finding finding;
};

struct Judgement {
  Verdict verdict = Verdict::sign;
  std::vector<StageFinding> findings;  // the most severe first, in the order of the stages otherwise
};

std::string_view severity_name(Severity severity);  // "note", "look", "refused"
std::string_view verdict_name(Verdict verdict);     // "sign", "look", "refused"

// The worst finding decides. A warning that is no finding is listed as a note with the code "warning". A stage that
// ended early on request is a finding with the code "finished_early", to be looked at.
Judgement judge(const std::vector<StageRecord>& stages);

}  // namespace base
}  // namespace bole
