// Ring and time of points in frames that come without them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace bole::io {

// Rings of a frame whose points are stored ring after ring, each going once around from azimuth 0 anticlockwise
// (KITTI): a ring ends where the azimuth goes from negative to positive. Empty when the points are not in such an order
// (another number of turns than 8 to 160, or turns that do not differ in elevation).
std::vector<std::uint16_t> rings_from_order(std::span<const Eigen::Vector3f> positions);

// The ring whose elevation is nearest; `elevations_rad` lowest first.
std::vector<std::uint16_t> rings_from_elevations(std::span<const Eigen::Vector3f> positions,
                                                 std::span<const double> elevations_rad);

// Evenly spaced elevations between the lowest and highest half percent of the points: for sensors that are not known.
std::vector<double> even_elevations_rad(std::span<const Eigen::Vector3f> positions, int rings);

// Mean elevation of each ring.
std::vector<double> mean_elevations_rad(std::span<const Eigen::Vector3f> positions,
                                        std::span<const std::uint16_t> rings);

// Time after the start of the turn for a rotor that turns clockwise and starts behind: t = period / 2 * (1 - azimuth /
// pi), so that it faces forward in the middle of the frame.
std::vector<float> times_from_azimuths(std::span<const Eigen::Vector3f> positions, double period_s);

}  // namespace bole::io
