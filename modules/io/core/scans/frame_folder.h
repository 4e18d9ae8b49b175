// Scans as a folder with one file per frame: .bin (KITTI) or .pcd.
#pragma once

#include <optional>
#include <vector>

#include "io/core/scans/frame_source.h"
#include "sensor/core/sensor_model.h"

namespace bole::io {

// 000000.bin holds x, y, z and intensity as little-endian float32 per point, in sensor axes. 000000.pcd has the fields
// x y z and, optionally, intensity, ring (channel) and time (t, timestamp). Intensities of .bin files from 0 to 1, as
// in KITTI, become 0 to 255, as in packets. Beside the frames:
//
// - times.txt: one line per frame, seconds (timestamps.txt: KITTI's dates), here or one folder up. Without either,
//   frames follow at frame_period.
// - 000000.time: float32 per point of 000000.bin, seconds after the frame's line in times.txt, which is its start.
// - 000000.ring: uint16 per point of 000000.bin, ring, 0 lowest.
// - sensor.json: {"sensor": "os1_64"}, a name of resources/sensors, or a description as in the files there.
//
// Without .time files a frame's line is the moment when the sensor faced forward, in the middle of a clockwise
// revolution that starts behind. The times of the points then follow from their azimuths. Without rings, they follow
// from the order of the points (KITTI) or from their elevations.
class FrameFolderSource : public FrameSource {
 public:
  // Throws Error{bad_input} when the folder holds no frames or the first one cannot be read.
  FrameFolderSource(const std::filesystem::path& folder, const FrameSourceOptions& options, const Run& run);

  std::size_t size() const override { return files_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override { return start_times_s_.at(index); }
  int rings() const override {
    return pattern() == ScanPattern::rosette ? 1 : static_cast<int>(elevations_rad_.size());
  }
  ScanPattern pattern() const override { return model_ ? model_->pattern() : ScanPattern::lines; }
  std::vector<double> ring_elevations_rad() const override { return elevations_rad_; }
  std::string sensor_model() const override { return model_ ? model_->id : "unknown"; }
  Facts facts() const override { return facts_; }
  std::string description() const override;
  std::string locator() const override { return frame_source_locator(folder_, options_); }

  const Report& report() const { return report_; }

  // Frames lie in the folder itself.
  static bool holds_frames(const std::filesystem::path& folder);
  // The folder itself, or the one below it where KITTI keeps the frames of a recording. Nothing where neither has any.
  static std::optional<std::filesystem::path> find_frames(const std::filesystem::path& folder);

 private:
  void find_files();
  void check_sizes();
  void find_times();
  void find_sensor();
  void learn_rings();
  void learn_own_rings(ScanFrame first);
  void learn_rings_from_order(const ScanFrame& first);
  std::vector<ScanFrame> sample_frames() const;
  void load(std::size_t index, ScanFrame& frame) const;
  void keep_valid(ScanFrame& frame) const;

  std::filesystem::path folder_;
  FrameSourceOptions options_;
  std::vector<std::filesystem::path> files_;
  std::vector<double> start_times_s_;
  double period_s_ = 0.1;
  std::optional<sensor::SensorModel> model_;
  bool ring_order_ = false;
  float intensity_factor_ = 1;
  std::vector<double> elevations_rad_;
  Facts facts_;
  Report report_;
};

}  // namespace bole::io
