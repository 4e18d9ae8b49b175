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
// recorder, and its clock counts on from there.
class OusterSource : public FrameSource {
 public:
  // Throws Error{bad_input} where no packet fits the metadata.
  OusterSource(std::unique_ptr<DatagramReader> packets, sensor::OusterMetadata metadata,
               const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run);

  std::size_t size() const override { return frames_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override { return seconds(frames_.at(index).first_time_ns); }
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
  };
  struct Counts;

  void index(const Run& run);
  void add(const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts);
  void sort_inertial(Counts& counts);
  void drop_partial_ends();
  bool is_whole(const Frame& frame) const;
  void fill_report(const Counts& counts);
  double seconds(std::int64_t time_ns) const { return clock_offset_s_ + 1e-9 * static_cast<double>(time_ns); }

  std::filesystem::path path_;
  std::string name_;
  FrameSourceOptions options_;
  std::unique_ptr<DatagramReader> reader_;
  sensor::OusterDecoder decoder_;
  mutable std::vector<sensor::OusterReturn> returns_;
  std::vector<Frame> frames_;
  InertialRecord inertial_;
  double clock_offset_s_ = 0;  // from the sensor's clock to the times of the frames
  int port_ = 0;
  Facts facts_;
  Report report_;
};

}  // namespace bole::io
