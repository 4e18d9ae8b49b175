#include "sim/core/walk/scan_writer.h"

#include <fstream>

#include "base/error.h"
#include "sensor/core/hesai_encoder.h"
#include "sensor/core/ouster_encoder.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"
#include "sim/core/walk/frame_file_writer.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

void write_text_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw failure("cannot write " + file.string(), "a writable folder with free space");
}

class VelodyneScanWriter final : public ScanWriter {
 public:
  VelodyneScanWriter(const sensor::SensorModel& sensor, const fs::path& file, double epoch_s, bool dual)
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

// Packets of other makers, with the file beside them that readers need.
template <class Encoder>
class PacketScanWriter final : public ScanWriter {
 public:
  PacketScanWriter(const sensor::SensorModel& sensor, const fs::path& file, std::uint16_t port, double epoch_s,
                   double rotation_hz, bool dual)
      : epoch_s_(epoch_s),
        pcap_(file, port),
        encoder_(sensor, rotation_hz, dual,
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
  if (sensor.packet == PacketFormat::velodyne)
    return std::make_unique<VelodyneScanWriter>(sensor, out_dir / "walk.pcap", epoch_s, dual);
  if (!dual) return std::make_unique<FrameFileWriter>(sensor, out_dir / "frames", epoch_s);
  if (sensor.packet == PacketFormat::ouster) {
    using Encoder = sensor::OusterEncoder;
    auto writer = std::make_unique<PacketScanWriter<Encoder>>(sensor, out_dir / "walk.pcap", Encoder::lidar_port,
                                                              epoch_s, rotation_hz, dual);
    write_text_file(out_dir / "walk.json", writer->encoder().metadata());
    return writer;
  }
  if (sensor.packet == PacketFormat::hesai) {
    constexpr std::uint16_t port = 2368;
    auto writer = std::make_unique<PacketScanWriter<sensor::HesaiEncoder>>(sensor, out_dir / "walk.pcap", port, epoch_s,
                                                                           rotation_hz, dual);
    write_text_file(out_dir / "walk.csv", writer->encoder().correction());
    return writer;
  }
  throw bad_input("the recording of the sensor " + sensor.name + " is written as frames, which hold one return",
                  "dual_return=false, or a sensor with packets of Velodyne, Ouster or Hesai");
}

}  // namespace bole::sim
