// Frames and inertial samples of an Ouster sensor from its packets, in a capture or in a bag.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/report.h"
#include "io/core/scans/datagrams.h"
#include "io/core/scans/frame_source.h"
#include "sensor/core/ouster_decoder.h"

namespace bole::io {

// The packets are read once to find where each frame starts. Frames are decoded when they are read. A frame is what the
// sensor calls one: the columns with the same frame id, from behind the sensor, or those in its azimuth window.
// Times: where the sensor's clock agrees with the recorder's it is UTC. Otherwise its first packet gets the time of the
// recorder, and its clock counts on from there. Where its clock was set during the recording (PTP, GPS) the times go on
// without the jump.
class OusterSource : public FrameSource {
 public:
  // Throws Error{bad_input} where no packet fits the metadata.
  OusterSource(std::unique_ptr<DatagramReader> packets, sensor::OusterMetadata metadata,
               const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run);

  std::size_t size() const override { return frames_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override {
    const auto& frame = frames_.at(index);
    return seconds(frame, frame.first_time_ns);
  }
  int rings() const override { return decoder_.metadata().model.rings(); }
  const InertialRecord* inertial() const override { return inertial_.samples.empty() ? nullptr : &inertial_; }
  std::vector<double> ring_elevations_rad() const override { return decoder_.metadata().model.ring_elevations_rad(); }
  std::string sensor_model() const override { return decoder_.metadata().model.id; }
  Facts facts() const override { return facts_; }
  std::string description() const override;
  std::string locator() const override { return frame_source_locator(path_, options_); }

  const Report& report() const { return report_; }

 private:
  struct Frame {
    std::int64_t begin = 0, end = 0;  // first and last packet
    std::uint16_t id = 0;
    int columns = 0;
    std::int64_t first_time_ns = 0, last_time_ns = 0;
    std::size_t clock = 0;                      // in clocks_
    std::vector<std::int64_t> packet_times_ns;  // while packets of it may still come
  };
  // What the sensor's clock told between two times at which it was set.
  struct ClockSpan {
    std::int64_t first_ns = 0, last_ns = 0;
    double offset_s = 0;  // to the times of the frames
  };
  // A packet as long as those of the inertial unit.
  struct InertialCandidate {
    InertialSample sample;
    int port = 0;
    std::size_t clock = 0;  // at its place in the recording
  };
  struct Counts {
    std::int64_t datagrams = 0, data = 0, inertial = 0, other = 0, other_port = 0, empty = 0, out_of_order = 0,
                 other_sensor = 0, skipped = 0, inertial_twice = 0, inertial_foreign = 0, duplicates = 0,
                 clock_jumps = 0;
    bool follows_utc = false;
    double recorded_s = 0;       // of the last lidar packet
    std::int64_t sensor_ns = 0;  // the same on the clock of the sensor
    std::vector<InertialCandidate> inertial_packets;
  };

  void index(const Run& run);
  void index_packets(const Run& run, Counts& counts);
  bool of_another_sensor(const sensor::OusterPacketHead& head) const;
  void follow_clock(const sensor::OusterPacketHead& head, double recorded_s, Counts& counts);
  void add(const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts);
  void add_to(Frame& frame, const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts);
  int inertial_port(const Counts& counts) const;
  void sort_inertial(Counts& counts);
  std::int64_t lost_revolutions() const;
  void drop_partial_ends();
  bool is_whole(const Frame& frame) const;
  void fill_report(const Counts& counts);
  double seconds(const Frame& frame, std::int64_t time_ns) const {
    return clocks_[frame.clock].offset_s + 1e-9 * static_cast<double>(time_ns);
  }

  std::filesystem::path path_;
  std::string name_;
  FrameSourceOptions options_;
  std::unique_ptr<DatagramReader> reader_;
  sensor::OusterDecoder decoder_;
  mutable std::vector<sensor::OusterReturn> returns_;
  std::vector<Frame> frames_;
  InertialRecord inertial_;
  std::vector<ClockSpan> clocks_;
  std::int64_t begin_ = 0;         // of the first packet
  bool own_packets_only_ = false;  // the recording has packets of this sensor and of another one
  int port_ = 0;
  Facts facts_;
  Report report_;
};

}  // namespace bole::io
