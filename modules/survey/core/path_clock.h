// How the times of a trajectory become those of the points: the offsets between the clocks that programs write.
#pragma once

#include <string>
#include <vector>

namespace bole::survey {

struct TimeSpan {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
};

// time of the points = time of the trajectory + offset.
struct ClockOffset {
  double offset_s = 0;
  std::string meaning;  // "the points have GPS time, the trajectory seconds of the GPS week"
};

// UTC - Unix epoch to GPS time: seconds that GPS is ahead of UTC at a Unix time (after 1980).
int leap_seconds(double unix_s);

// The pairs of clocks by which the two spans overlap: GPS time (since 1980), the same less 1e9 s (LAS), seconds of the
// GPS week, Unix time (UTC), and the same clock in both. Each offset once.
std::vector<ClockOffset> possible_offsets(const TimeSpan& points, const TimeSpan& path);

// "from 0.1 to 384.2 s (seconds from a start, or of a week)".
std::string described(const TimeSpan& span);

}  // namespace bole::survey
