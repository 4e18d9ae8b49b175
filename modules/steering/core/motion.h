// The direction in which a vehicle moved, from its positions alone.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace bole::steering {

// Numbers the stretches of samples between gaps, from 1: a step in time longer than `max_gap_s` begins a new one, and a
// step that nothing in a field drives so fast (54 km/h), for there the position jumped.
std::vector<std::int64_t> segments_between_gaps(const std::vector<double>& time_s,
                                                const std::vector<Eigen::Vector2d>& at, double max_gap_s);

// Yaw (east to north, radians) of the motion at each sample, from the samples about `look_m` before and behind it in
// its segment; NaN where these are less than `min_m` apart.
std::vector<double> motion_yaws(const std::vector<Eigen::Vector2d>& at, const std::vector<std::int64_t>& segment,
                                double look_m, double min_m);

}  // namespace bole::steering
