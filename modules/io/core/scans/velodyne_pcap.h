// Frames of a Velodyne sensor, or of another one that turns, from its packets, in a capture or in a bag.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "io/core/bytes/mapped_file.h"
#include "io/core/scans/datagrams.h"
#include "io/core/scans/frame_source.h"
#include "io/core/scans/packet_clock.h"
#include "sensor/core/packet_decoder.h"

namespace bole::io {

// The packets are read once to find where each frame starts, which takes a few dozen bytes per frame. Frames are
// decoded when they are read. A frame is one revolution of the rotor from the cut angle. It also ends where the
// recording is interrupted for so long that the rotor passed the cut angle, or where the sensor's clock was set.
class VelodynePcapSource : public FrameSource {
 public:
  // Throws Error{bad_input} where there is no Velodyne data packet or the sensor is not known.
  VelodynePcapSource(const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run);
  VelodynePcapSource(Bytes capture, const std::string& name, const FrameSourceOptions& options, const Run& run);
  // `decoder`: of a sensor that is known; null: the packets say which Velodyne sensor it is.
  VelodynePcapSource(std::unique_ptr<DatagramReader> packets, const std::filesystem::path& path,
                     const FrameSourceOptions& options, const Run& run,
                     std::unique_ptr<sensor::PacketDecoder> decoder = nullptr);

  std::size_t size() const override { return frames_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override { return frames_.at(index).start_time_s; }
  int rings() const override { return decoder_->model().rings(); }
  std::vector<double> ring_elevations_rad() const override { return decoder_->model().ring_elevations_rad(); }
  std::string sensor_model() const override { return decoder_->model().id; }
  Facts facts() const override { return facts_; }
  std::string description() const override;
  std::string locator() const override { return frame_source_locator(path_, options_); }

  const Report& report() const { return report_; }

 private:
  struct Mark {
    std::int64_t offset = 0;  // of the packet in the file
    std::size_t firing = 0;
  };
  struct Frame {
    Mark begin, end;           // `end` is the last packet and one past the last firing in it
    double start_time_s = 0;   // of the first firing
    double packet_time_s = 0;  // of the packet that holds it
    std::uint32_t past_hour_us = 0;
    double turned_centideg = 0;
  };
  class Indexer;

  void index(const Run& run);
  double usual_turn_centideg() const;
  void drop_partial_ends();
  void recognise(Bytes payload);
  void decode_as(sensor::SensorModel model);
  bool next_packet(Datagram& datagram) const;
  void append(const sensor::VelodyneReturn& r, double packet_offset_s, ScanFrame& frame) const;

  std::filesystem::path path_;
  std::string name_;
  FrameSourceOptions options_;
  std::unique_ptr<DatagramReader> reader_;
  mutable std::vector<sensor::VelodyneReturn> returns_;
  mutable std::vector<sensor::VelodyneFiring> firings_;
  std::unique_ptr<sensor::PacketDecoder> decoder_;
  std::vector<Frame> frames_;
  int port_ = 0;
  Facts facts_;
  Report report_;
};

}  // namespace bole::io
