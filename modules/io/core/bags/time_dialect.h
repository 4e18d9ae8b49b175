// How the drivers of the makers write the time of a point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/core/bags/raw_points.h"

namespace bole::io {

// after_stamp: t after (or, negative, before) the stamp of the message; own_clock: absolute times.
enum class TimeOrigin { none, after_stamp, own_clock };

struct TimeDialect {
  TimeOrigin origin = TimeOrigin::none;
  double unit_s = 1;
  double shift_s = 0;      // from the points' clock to that of the stamps
  double jump_s = 0;       // own_clock: a frame that starts further from its stamp than this starts at the stamp
  bool from_base = false;  // of Livox messages: after their time base, not after their stamp
  std::string text;        // for the report: "t, ns after the stamp of the message, which is the start of the sweep"
  std::string warning;     // empty where all is clear
};

// What one message shows.
struct TimeSample {
  double stamp_s = 0, recorded_s = 0;
  double first = 0, last = 0;  // of its points, in the unit of the recording
};
std::optional<TimeSample> time_sample(const RawPoints& points, std::int64_t recorded_ns);

// Decides by the values: one sweep lasts about as long as the messages are apart (`period_s`), which gives the unit.
// Times far from zero are absolute.
TimeDialect find_time_dialect(const std::optional<CloudField>& field, const std::vector<TimeSample>& samples,
                              double period_s);

// Of Livox messages, whose time bases and stamps are up to `apart_s` apart. The time base is the stamp on the sensor's
// clock. Where that is another clock the stamps count, in all messages.
TimeDialect livox_dialect(double apart_s, double period_s);

}  // namespace bole::io
