// The log of a filtered track, a row per fix.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "geo/core/attitude.h"
#include "steering/core/navigator.h"
#include "steering/core/track/track_headings.h"

namespace bole::steering {

class NavigationLog {
 public:
  void add(const AntennaFix& fix, const geo::Attitude& attitude, const NavigatedPoint& point,
           const PositionVelocityFilter& filter);
  // The columns of NavigatedTrack::log.
  Table table(const Facts& facts, bool with_run) &&;
  std::int64_t doubted() const;

 private:
  static constexpr std::array names{"time_s",   "x_m",         "y_m",         "x_se_m",  "y_se_m",    "gnss_x_m",
                                    "gnss_y_m", "antenna_x_m", "antenna_y_m", "yaw_deg", "speed_m_s", "sigma_m"};
  std::array<std::vector<double>, names.size()> columns_;
  std::vector<std::int64_t> quality_, run_, segment_;
  std::vector<std::string> state_;
};

}  // namespace bole::steering
