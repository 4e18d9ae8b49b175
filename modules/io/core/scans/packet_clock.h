// Absolute times from a Velodyne sensor's "microseconds past the hour" and the capture's own clock.
#pragma once

#include <cstdint>

namespace bole::io {

// The sensor's clock gives the exact time past the hour, the capture's clock gives the hour. A sensor without GPS
// counts from when it was switched on. Its first packet gets the capture time, and its clock counts on from there.
class PacketClock {
 public:
  // Time of the packet, seconds since the Unix epoch. Packets may come slightly out of order.
  double time_s(std::uint32_t past_hour_us, double capture_time_s);

  // The sensor's clock jumped against the capture's, because GPS set it. Times continue without the jump.
  bool jumped() const { return jumped_; }
  bool follows_utc() const { return follows_utc_; }  // the sensor's clock agreed with the capture's at the first packet

 private:
  bool started_ = false, follows_utc_ = false, jumped_ = false;
  // Whole microseconds are counted: sums of steps of some 100 us on top of 1.7e9 s would drift by up to 0.2 ms a second.
  double start_s_ = 0, capture_time_s_ = 0;
  std::int64_t since_start_us_ = 0;
  std::uint32_t past_hour_us_ = 0;
};

// b - a of two times past the hour that are less than half an hour apart, microseconds.
std::int64_t past_hour_difference_us(std::uint32_t a_us, std::uint32_t b_us);

}  // namespace bole::io
