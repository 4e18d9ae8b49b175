// Rings of a recording in the order that frames have: from the lowest elevation upwards. Some makers count from the
// top, others in the order of firing.
#pragma once

#include <string>
#include <vector>

#include "io/core/bags/raw_points.h"

namespace bole::io {

class RingOrder {
 public:
  // From frames spread over the recording. Empty where the numbers can be no rings.
  static RingOrder learn(const std::vector<RawPoints>& samples);

  bool empty() const { return elevations_rad_.empty(); }
  int rings() const { return static_cast<int>(elevations_rad_.size()); }
  const std::vector<double>& elevations_rad() const { return elevations_rad_; }  // lowest first
  const std::string& text() const { return text_; }

  // The ring of a point. One with a number that the sample did not have gets the ring of the nearest elevation.
  std::uint16_t ring(std::int64_t number, const Eigen::Vector3f& position) const;

 private:
  std::vector<std::uint16_t> place_;  // by number
  std::vector<double> elevations_rad_;
  std::string text_;
};

}  // namespace bole::io
