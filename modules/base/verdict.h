// Whether the result of a run may be signed, and why not.
#pragma once

#include <cstddef>
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

// Codes that programs act on; the words stay the same from version to version.
namespace finding_code {
inline constexpr const char* finished_early = "finished_early";
inline constexpr const char* output_not_written = "output_not_written";  // the run fails: exit code 1
inline constexpr const char* input_incomplete = "input_incomplete";      // likewise, unless it is accepted
inline constexpr const char* input_not_usable = "input_not_usable";      // an output has no fit input: exit code 2
}  // namespace finding_code

bool has_finding(const Report& report, std::string_view code);

std::string_view severity_name(Severity severity);  // "note", "look", "refused"
std::string_view verdict_name(Verdict verdict);     // "sign", "look", "refused"

// The verdict in the words of the page and the console: "Sign after a look at 1 tree". Doubtful trees in the plot are
// to be looked at whatever the run as a whole is worth; they do not change the verdict.
std::string verdict_headline(Verdict verdict, std::size_t trees_to_look_at = 0);
// The count of a report of that name.
inline constexpr const char* trees_to_look_at_count = "trees_to_look_at";

// The worst finding decides. A warning that is no finding is listed as a note with the code "warning". A stage that
// ended early is a finding with the code "finished_early", to be looked at.
Judgement judge(const std::vector<StageRecord>& stages);

}  // namespace base
}  // namespace bole
