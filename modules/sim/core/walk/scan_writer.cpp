#include "sim/core/walk/scan_writer.h"

#include <utility>

#include "base/atomic_file.h"
#include "base/error.h"
#include "sensor/core/hesai_encoder.h"
#include "sensor/core/ouster_encoder.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"
#include "sim/core/walk/frame_file_writer.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

// Packets of a maker in a pcap file. `of_encoder`: what its encoder is made of, before the sink.
template <class Encoder>
class PacketScanWriter final : public ScanWriter {
 public:
  template <class... OfEncoder>
  PacketScanWriter(const fs::path& file, std::uint16_t port, double epoch_s, OfEncoder&&... of_encoder)
      : epoch_s_(epoch_s),
        pcap_(file, port),
        encoder_(std::forward<OfEncoder>(of_encoder)...,
                 [this](std::span<const std::uint8_t> packet, double time_s) { pcap_.write(packet, time_s); }) {}
  const Encoder& encoder() const { return encoder_; }
  void add(const FiringSequence& s) override { encoder_.add(epoch_s_ + s.time_s, s.azimuth_rad, s.echoes, s.last); }
  void close() override {
    encoder_.flush();
    pcap_.close();
  }

 private:
  double epoch_s_;
  sensor::PcapWriter pcap_;
  Encoder encoder_;
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_writer(const sensor::SensorModel& sensor, const fs::path& out_dir, double epoch_s,
                                             double rotation_hz, bool dual) {
  using sensor::PacketFormat;
  constexpr std::uint16_t port = 2368;  // of Velodyne and Hesai
  if (sensor.packet == PacketFormat::velodyne) {
    using sensor::VelodyneReturnMode;
    return std::make_unique<PacketScanWriter<sensor::VelodyneEncoder>>(
        out_dir / "walk.pcap", port, epoch_s, sensor, dual ? VelodyneReturnMode::dual : VelodyneReturnMode::strongest);
  }
  if (!dual) return std::make_unique<FrameFileWriter>(sensor, out_dir / "frames", epoch_s);
  if (sensor.packet == PacketFormat::ouster) {
    using Encoder = sensor::OusterEncoder;
    auto writer = std::make_unique<PacketScanWriter<Encoder>>(out_dir / "walk.pcap", Encoder::lidar_port, epoch_s,
                                                              sensor, rotation_hz, dual);
    write_text_file(out_dir / "walk.json", writer->encoder().metadata());
    return writer;
  }
  if (sensor.packet == PacketFormat::hesai) {
    auto writer = std::make_unique<PacketScanWriter<sensor::HesaiEncoder>>(out_dir / "walk.pcap", port, epoch_s, sensor,
                                                                           rotation_hz, dual);
    write_text_file(out_dir / "walk.csv", writer->encoder().correction());
    return writer;
  }
  throw bad_input("the recording of the sensor " + sensor.name + " is written as frames, which hold one return",
                  "dual_return=false, or a sensor with packets of Velodyne, Ouster or Hesai");
}

}  // namespace bole::sim
