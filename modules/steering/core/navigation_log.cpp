#include "steering/core/navigation_log.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/angles.h"
#include "base/no_number.h"

namespace bole::steering {

void NavigationLog::add(const AntennaFix& fix, const geo::Attitude& attitude, const NavigatedPoint& point,
                        const PositionVelocityFilter& filter) {
  const auto sigma = filter.position_sigma();
  const auto received = point.received.value_or(Eigen::Vector2d(no_number, no_number));
  const double values[] = {fix.time_s,
                           point.position.x(),
                           point.position.y(),
                           sigma.x(),
                           sigma.y(),
                           received.x(),
                           received.y(),
                           fix.antenna_nav.x(),
                           fix.antenna_nav.y(),
                           degrees(attitude.yaw_rad),
                           filter.velocity().norm(),
                           fix.sigma_m};
  for (std::size_t i = 0; i < std::size(values); ++i) columns_[i].push_back(values[i]);
  quality_.push_back(fix.quality);
  run_.push_back(fix.run);
  segment_.push_back(fix.segment);
  state_.emplace_back(filter.doubts() ? "doubted" : "used");
}

Table NavigationLog::table(const Facts& facts, bool with_run) && {
  Table t;
  if (with_run) t.set("run", std::move(run_));
  for (std::size_t i = 0; i < names.size(); ++i) t.set(names[i], std::move(columns_[i]));
  t.set("quality", std::move(quality_));
  t.set("segment", std::move(segment_));
  t.set("state", std::move(state_));
  t.facts = facts;
  return t;
}

std::int64_t NavigationLog::doubted() const { return std::ranges::count(state_, "doubted"); }

}  // namespace bole::steering
