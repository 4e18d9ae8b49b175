#include "sim/core/walk/scan_writer.h"

#include "base/error.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"
#include "sim/core/walk/frame_file_writer.h"

namespace bole::sim {
namespace {

class VelodyneScanWriter final : public ScanWriter {
 public:
  VelodyneScanWriter(const sensor::SensorModel& sensor, const std::filesystem::path& file, double epoch_s, bool dual)
      : epoch_s_(epoch_s),
        pcap_(file),
        encoder_(sensor, dual ? sensor::VelodyneReturnMode::dual : sensor::VelodyneReturnMode::strongest,
                 [this](const sensor::VelodyneEncoder::Bytes& packet, double time_s) { pcap_.write(packet, time_s); }) {
  }
  void add(const FiringSequence& s) override { encoder_.add(epoch_s_ + s.time_s, s.azimuth_rad, s.echoes, s.last); }
  void close() override {
    encoder_.flush();
    pcap_.close();
  }

 private:
  double epoch_s_;
  sensor::PcapWriter pcap_;
  sensor::VelodyneEncoder encoder_;
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_writer(const sensor::SensorModel& sensor, const std::filesystem::path& out_dir,
                                             double epoch_s, bool dual) {
  if (sensor.packet == sensor::PacketFormat::velodyne)
    return std::make_unique<VelodyneScanWriter>(sensor, out_dir / "walk.pcap", epoch_s, dual);
  if (dual)
    throw bad_input("the recording of the sensor " + sensor.name + " is written as frames, which hold one return",
                    "dual_return=false, or a sensor with Velodyne packets and dual return");
  return std::make_unique<FrameFileWriter>(sensor, out_dir / "frames", epoch_s);
}

}  // namespace bole::sim
