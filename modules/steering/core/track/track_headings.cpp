#include "steering/core/track/track_headings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "cloud/table_columns.h"
#include "steering/core/motion.h"

namespace bole::steering {
namespace {

constexpr double min_speed_m_s = 0.5;  // a course of less is noise
constexpr double motion_look_m = 1.0;  // over which the direction of motion is taken
constexpr double max_step_s = 1.0;     // between two measured attitudes

// Angles of a table of attitudes at any time; NaN outside it and in its gaps.
class Attitudes {
 public:
  explicit Attitudes(const Table& t)
      : time_(t.numbers("time_s")),
        roll_(radians_of(t, "roll_deg")),
        pitch_(radians_of(t, "pitch_deg")),
        heading_(radians_of(t, "heading_deg")),
        yaw_(radians_of(t, "yaw_deg")) {
    if (!t.has("roll_deg") && !t.has("pitch_deg") && !t.has("heading_deg") && !t.has("yaw_deg"))
      throw bad_input("the attitudes hold no angle", "roll_deg, pitch_deg, heading_deg or yaw_deg");
    for (std::size_t i = 1; i < time_.size(); ++i)
      if (!(time_[i] > time_[i - 1]))
        throw bad_input(fmt::format("time_s of the attitudes does not rise at row {}", i + 1), "rising times");
  }

  double roll(double time_s) const { return angle(roll_, time_s); }
  double pitch(double time_s) const { return angle(pitch_, time_s); }
  double heading(double time_s) const { return angle(heading_, time_s); }
  double yaw(double time_s) const { return angle(yaw_, time_s); }

 private:
  static std::vector<double> radians_of(const Table& t, const char* name) {
    auto values = numbers_or_nan(t, name);
    for (double& v : values) v = radians(v);
    return values;
  }
  double angle(const std::vector<double>& values, double time_s) const {
    const auto j = static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), time_s) - time_.begin());
    if (j > 0 && time_[j - 1] == time_s) return values[j - 1];
    if (j == 0 || j == time_.size() || time_[j] - time_[j - 1] > max_step_s) return no_number;
    const double s = (time_s - time_[j - 1]) / (time_[j] - time_[j - 1]);
    return wrapped(values[j - 1] + s * wrapped(values[j] - values[j - 1]));
  }
  std::vector<double> time_, roll_, pitch_, heading_, yaw_;
};

// Direction of motion at each fix; NaN where it did not get as far as a metre.
std::vector<double> motion_of(const std::vector<AntennaFix>& fixes) {
  std::vector<Eigen::Vector2d> at;
  std::vector<std::int64_t> segment;
  for (const auto& fix : fixes) {
    at.push_back(fix.antenna_nav);
    segment.push_back(fix.segment);
  }
  return motion_yaws(at, segment, motion_look_m, motion_look_m);
}

// Nothing for the heading of a fix: that of the nearest one in its segment which has it.
void keep_last(const std::vector<AntennaFix>& fixes, std::vector<geo::Attitude>& at) {
  for (std::size_t i = 1; i < at.size(); ++i)
    if (std::isnan(at[i].yaw_rad) && fixes[i].segment == fixes[i - 1].segment) at[i].yaw_rad = at[i - 1].yaw_rad;
  for (std::size_t i = at.size(); i-- > 1;)
    if (std::isnan(at[i - 1].yaw_rad) && fixes[i].segment == fixes[i - 1].segment) at[i - 1].yaw_rad = at[i].yaw_rad;
}

}  // namespace

TrackAttitudes attitudes_of(const std::vector<AntennaFix>& fixes, const Table& track, const Table* attitude,
                            const NavigateOptions& o) {
  const std::optional<Attitudes> table = attitude != nullptr ? std::optional<Attitudes>(*attitude) : std::nullopt;
  const auto heading = numbers_or_nan(track, "heading_deg"), course = numbers_or_nan(track, "course_deg"),
             speed = numbers_or_nan(track, "speed_m_s"), convergence = numbers_or_nan(track, "convergence_deg");
  const auto motion = motion_of(fixes);
  const bool any = o.heading == HeadingSource::automatic;
  TrackAttitudes found;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const auto& fix = fixes[i];
    const double turn = std::isfinite(convergence[fix.row]) ? convergence[fix.row] : 0;
    const auto in_plane = [&](double bearing_deg) { return geo::yaw_from_bearing_rad(radians(bearing_deg - turn)); };
    geo::Attitude a{0, 0, no_number};
    if (table) {
      const double roll = table->roll(fix.time_s), pitch = table->pitch(fix.time_s);
      found.tilt_known = found.tilt_known || std::isfinite(roll) || std::isfinite(pitch);
      a.roll_rad = std::isfinite(roll) ? roll : 0;
      a.pitch_rad = std::isfinite(pitch) ? pitch : 0;
    }
    if (any || o.heading == HeadingSource::measured) {
      if (table) a.yaw_rad = table->yaw(fix.time_s);
      if (table && std::isnan(a.yaw_rad)) a.yaw_rad = in_plane(degrees(table->heading(fix.time_s)));
      if (std::isnan(a.yaw_rad)) a.yaw_rad = in_plane(heading[fix.row]);
      if (std::isfinite(a.yaw_rad)) {
        a.yaw_rad = wrapped(a.yaw_rad - radians(o.heading_offset_deg));
        ++found.measured;
      }
    }
    if (std::isnan(a.yaw_rad) && (any || o.heading == HeadingSource::course) && speed[fix.row] >= min_speed_m_s) {
      a.yaw_rad = in_plane(course[fix.row]);
      found.by_course += std::isfinite(a.yaw_rad) ? 1 : 0;
    }
    if (std::isnan(a.yaw_rad) && (any || o.heading == HeadingSource::motion)) {
      a.yaw_rad = motion[i];
      found.by_motion += std::isfinite(a.yaw_rad) ? 1 : 0;
    }
    found.at.push_back(a);
  }
  keep_last(fixes, found.at);
  found.without_heading = static_cast<std::size_t>(
      std::ranges::count_if(found.at, [](const geo::Attitude& a) { return std::isnan(a.yaw_rad); }));
  return found;
}

}  // namespace bole::steering
