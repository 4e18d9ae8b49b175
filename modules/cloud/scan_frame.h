// One revolution of a spinning LiDAR, and a source that streams many.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/facts.h"
#include "cloud/inertial.h"

namespace bole {
inline namespace cloud {

// Structure of arrays, all of one length. Points are in sensor axes at their own firing time (rolling shutter, not
// de-skewed): x forward at azimuth 0, y left, z up. Range is positions[i].norm().
struct ScanFrame {
  double start_time_s = 0;  // of the first firing
  double end_time_s = 0;    // of the last
  std::vector<Eigen::Vector3f> positions;
  std::vector<float> time_offset_s;  // after start_time_s
  std::vector<std::uint16_t> ring;   // from the lowest elevation upwards
  std::vector<float> intensity;
  std::vector<std::uint8_t> return_number;  // 1 for the first of a dual return

  std::size_t size() const { return positions.size(); }
  void clear() { positions.clear(), time_offset_s.clear(), ring.clear(), intensity.clear(), return_number.clear(); }
};

// How the beams of a scanner cover its field of view. lines: each laser draws the same line in every revolution.
// rosette: the beams never repeat their path, and have no rings (Livox).
enum class ScanPattern { lines, rosette };

// Frames in order of time. Reading is by index and cheapest in order; a source may be read from one thread at a time.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::size_t size() const = 0;
  // Fills `frame` (its memory is re-used). Throws Error{bad_input} naming the frame when it cannot be decoded.
  virtual void read(std::size_t index, ScanFrame& frame) const = 0;
  virtual double frame_time_s(std::size_t index) const = 0;  // start of the frame
  virtual int rings() const = 0;                             // 1 for a rosette
  virtual ScanPattern pattern() const { return ScanPattern::lines; }
  // The inertial unit of the same recording, or null. Lives as long as the source.
  virtual const InertialRecord* inertial() const { return nullptr; }
  // Elevation of each ring in radians, lowest first; empty when not known.
  virtual std::vector<double> ring_elevations_rad() const { return {}; }
  virtual std::string sensor_model() const = 0;  // "vlp32c", ...; "unknown" when not known
  virtual Facts facts() const { return {}; }     // of the sensor and the recording
  virtual std::string description() const = 0;   // "walk.pcap: 812 frames, VLP-32C"
  // Where it came from, so that a stored result can name and reopen it: a JSON text that open_frame_source()
  // understands.
  virtual std::string locator() const = 0;
};

}  // namespace cloud
}  // namespace bole
