#include "sim/core/scan_writer.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

class VelodyneScanWriter final : public ScanWriter {
 public:
  VelodyneScanWriter(const SensorModel& sensor, const fs::path& file, double epoch_s)
      : epoch_s_(epoch_s), pcap_(file), encoder_(sensor, VelodyneReturnMode::strongest, [this](const VelodyneEncoder::Bytes& packet, double time_s) { pcap_.write(packet, time_s); }) {}
  void add(const FiringSequence& s) override { encoder_.add(epoch_s_ + s.time_s, s.azimuth_rad, s.echoes); }
  void close() override {
    encoder_.flush();
    pcap_.close();
  }

 private:
  double epoch_s_;
  PcapWriter pcap_;
  VelodyneEncoder encoder_;
};

// One file per turn, float32 x, y, z, intensity (0 to 1) in sensor axes, points in order of firing.
class FrameFileWriter final : public ScanWriter {
 public:
  FrameFileWriter(const SensorModel& sensor, const fs::path& folder, double epoch_s) : sensor_(sensor), folder_(folder), epoch_s_(epoch_s) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void add(const FiringSequence& s) override {
    if (s.azimuth_rad < last_azimuth_rad_ - 1e-9 && !points_.empty()) finish_frame(s.time_s);
    last_azimuth_rad_ = s.azimuth_rad;
    if (points_.empty()) start_s_ = s.time_s;
    for (std::size_t c = 0; c < s.echoes.size(); ++c) {
      const auto& echo = s.echoes[c];
      if (!(echo.range_m > 0)) continue;
      const auto& laser = sensor_.channels[c];
      const double range = sensor_.range_quantum_m > 0 ? std::round(echo.range_m / sensor_.range_quantum_m) * sensor_.range_quantum_m : echo.range_m;
      const double a = s.azimuth_rad + laser.azimuth_offset_rad, h = range * std::cos(laser.elevation_rad);
      points_.insert(points_.end(), {static_cast<float>(h * std::cos(a)), static_cast<float>(-h * std::sin(a)), static_cast<float>(range * std::sin(laser.elevation_rad)), static_cast<float>(echo.intensity) / 255.0f});
    }
  }
  void close() override {
    if (!points_.empty()) finish_frame(0);
    std::ofstream out(folder_ / "times.txt", std::ios::binary);
    char line[64];
    for (const double t : times_) {
      std::snprintf(line, sizeof line, "%.6f\n", epoch_s_ + t);
      out << line;
    }
    out.close();
    if (!out) throw failure("cannot write " + (folder_ / "times.txt").string(), "free space on the disk");
  }

 private:
  void finish_frame(double) {
    char name[32];
    std::snprintf(name, sizeof name, "%06zu.bin", times_.size());
    std::ofstream out(folder_ / name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(points_.data()), static_cast<std::streamsize>(points_.size() * sizeof(float)));
    out.close();
    if (!out) throw failure("cannot write " + (folder_ / name).string(), "free space on the disk");
    times_.push_back(start_s_);
    points_.clear();
  }
  const SensorModel& sensor_;
  fs::path folder_;
  double epoch_s_, start_s_ = 0, last_azimuth_rad_ = 0;
  std::vector<float> points_;
  std::vector<double> times_;
};

}  // namespace

std::unique_ptr<ScanWriter> make_scan_writer(const SensorModel& sensor, const fs::path& out_dir, double epoch_s) {
  if (sensor.packet == PacketFormat::velodyne) return std::make_unique<VelodyneScanWriter>(sensor, out_dir / "walk.pcap", epoch_s);
  return std::make_unique<FrameFileWriter>(sensor, out_dir / "frames", epoch_s);
}

}  // namespace bole::sim
