// The fixes of a track that are good enough, and what is left out.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "steering/core/track/navigate_track.h"
#include "steering/core/track/track_headings.h"

namespace bole::steering {

// Standard deviation of a fix of a track that says nothing, as the filter of the simulated drive has it.
inline constexpr double unknown_sigma_m = 0.01;

// What is left out, by reason.
struct FixesLeftOut {
  std::int64_t without_place = 0, poor = 0, back_in_time = 0;
  std::map<std::int64_t, std::int64_t> by_quality;  // of all fixes
};

// "4: 1200, 5: 31": fixes by quality.
std::string qualities_text(const FixesLeftOut& left_out);

// Finite fixes of accepted quality in order of time, with their segments (a gap of more than max_gap starts a new one)
// and standard deviations. Throws Error{bad_input} where `accept` names no quality.
std::vector<AntennaFix> accepted_fixes(const Table& track, const NavigateOptions& options, FixesLeftOut& left_out);

}  // namespace bole::steering
