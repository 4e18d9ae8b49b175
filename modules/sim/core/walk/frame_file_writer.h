// Frames as files, for sensors without packets of their own here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sim/core/walk/scan_writer.h"

namespace bole::sim {

// One set of files per turn of the rotor (per 1 / rotation rate for a scanner without lines, ring 0): NNNNNN.bin
// (KITTI: float32 x, y, z, intensity 0 to 1; sensor axes, in order of firing), NNNNNN.time (float32 seconds after the
// frame's line in times.txt), NNNNNN.ring (uint16, 0 lowest); beside them times.txt (start of each frame, seconds since
// the Unix epoch) and sensor.json ({"sensor": id}).
class FrameFileWriter final : public ScanWriter {
 public:
  FrameFileWriter(const sensor::SensorModel& sensor, const std::filesystem::path& folder, double epoch_s);
  void add(const FiringSequence& sequence) override;
  void close() override;

 private:
  void finish_frame();
  template <class T>
  void write(const char* extension, const std::vector<T>& values) const;

  const sensor::SensorModel& sensor_;
  std::filesystem::path folder_;
  double epoch_s_, last_azimuth_rad_ = 0, last_time_s_ = 0;
  std::vector<float> points_, point_times_s_;
  std::vector<std::uint16_t> rings_;
  std::vector<double> frame_starts_s_;
  bool open_ = false;
};

}  // namespace bole::sim
