// The packets of a sensor, from a capture or from a bag, in order or from a given one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace bole::io {

// How many packets a reader looks at to know the sensor.
inline constexpr int sampled_packets = 256;

struct Datagram {
  double time_s = 0;                      // recording time, seconds since the Unix epoch
  std::int64_t offset = 0;                // its place in the recording, for DatagramReader::seek
  std::uint16_t port = 0;                 // UDP destination port; 0 in a bag
  std::span<const std::uint8_t> payload;  // valid until the next call
};

// A number of a network header: highest byte first.
inline std::uint16_t big16(std::span<const std::uint8_t> p, std::size_t i) {
  return static_cast<std::uint16_t>(p[i] << 8 | p[i + 1]);
}

class DatagramReader {
 public:
  virtual ~DatagramReader() = default;

  // The next packet. False at the end and where the recording is cut off or damaged; then trouble() gives the reason.
  // `poll` is called now and then with the place, and it may throw.
  virtual bool next(Datagram& datagram, const std::function<void(std::int64_t)>& poll) = 0;
  bool next(Datagram& datagram) { return next(datagram, {}); }

  // Continues at a packet whose offset next() has given.
  virtual void seek(std::int64_t offset) = 0;

  virtual double end() const = 0;  // the place behind the last packet; 0 where it is not known
  std::int64_t skipped() const { return skipped_; }
  std::int64_t fragments() const { return fragments_; }
  const std::string& trouble() const { return trouble_; }  // empty when the recording ended as it should
  std::int64_t trouble_at() const { return trouble_at_; }  // the place of the first record that cannot be read

 protected:
  std::int64_t skipped_ = 0, fragments_ = 0;
  std::string trouble_;
  std::int64_t trouble_at_ = 0;
};

}  // namespace bole::io
