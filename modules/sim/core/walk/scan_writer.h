// Raw sensor data as files.
#pragma once

#include <filesystem>
#include <memory>

#include "sensor/core/sensor_model.h"
#include "sim/core/walk/scan.h"

namespace bole::sim {

class ScanWriter {
 public:
  virtual ~ScanWriter() = default;
  virtual void add(const FiringSequence& sequence) = 0;
  virtual void close() = 0;  // throws Error{failed} when something could not be written
};

// walk.pcap for sensors with Velodyne packets, frames/NNNNNN.bin otherwise. With `dual`, two returns: walk.pcap with
// walk.json for an Ouster sensor, walk.pcap with walk.csv for a Hesai. `epoch_s`: the time of the first firing. Throws
// Error{bad_input} where the sensor has no packets with two returns.
std::unique_ptr<ScanWriter> make_scan_writer(const sensor::SensorModel& sensor, const std::filesystem::path& out_dir,
                                             double epoch_s, double rotation_hz, bool dual = false);

}  // namespace bole::sim
