// Ring and time of points in frames that come without them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace bole::io {

// Rings of a frame whose points are stored ring by ring, each anticlockwise from azimuth 0 (KITTI). A ring ends where
// the azimuth goes from negative to positive. Empty where the points are in another order: fewer than 8 or more than
// 160 revolutions, or revolutions that do not differ in elevation.
std::vector<std::uint16_t> rings_from_order(std::span<const Eigen::Vector3f> positions);

// The ring whose elevation is nearest; `elevations_rad` lowest first.
std::vector<std::uint16_t> rings_from_elevations(std::span<const Eigen::Vector3f> positions,
                                                 std::span<const double> elevations_rad);

// Evenly spaced elevations between the lowest and highest half percent of the points, for an unknown sensor.
std::vector<double> even_elevations_rad(std::span<const Eigen::Vector3f> positions, int rings);

// Mean elevation of each ring.
std::vector<double> mean_elevations_rad(std::span<const Eigen::Vector3f> positions,
                                        std::span<const std::uint16_t> rings);

// Time after the start of the frame, for a rotor that turns clockwise and starts behind: t = period / 2 * (1 - azimuth
// / pi). It faces forward in the middle of the frame.
std::vector<float> times_from_azimuths(std::span<const Eigen::Vector3f> positions, double period_s);

}  // namespace bole::io
