// Frames and inertial samples from LVX (version 1.1) and LVX2 files of Livox Viewer and the Livox SDK.
// Source: Livox "LVX Specifications" v1.1, "LVX2 Specifications" v2.0.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/transform.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/scans/frame_source.h"

namespace bole::io {

bool looks_like_lvx(Bytes file);

// The file has blocks of 50 ms; a frame joins those of about 0.1 s. The headers of the packages are read once, points
// when their frame is read. With one device the points are in its axes. With several, each device is placed by its
// extrinsics, and the axes are those of the rig.
class LvxSource : public FrameSource {
 public:
  // Throws Error{bad_input} where the file has no point.
  LvxSource(const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run);
  LvxSource(Bytes file, std::string name, const FrameSourceOptions& options, const Run& run);

  std::size_t size() const override { return frames_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override { return frames_.at(index).start_time_s; }
  int rings() const override { return 1; }
  ScanPattern pattern() const override { return ScanPattern::rosette; }
  const InertialRecord* inertial() const override { return inertial_.samples.empty() ? nullptr : &inertial_; }
  std::string sensor_model() const override { return sensor_; }
  Facts facts() const override { return facts_; }
  std::string description() const override;
  std::string locator() const override { return frame_source_locator(path_, options_); }

  const Report& report() const { return report_; }

 private:
  struct Device {
    std::uint32_t id = 0;  // index, or address in LVX2
    int type = -1;
    bool placed = false;
    Pose T_rig_device = Pose::Identity();
  };
  struct Package {
    std::size_t data = 0, bytes = 0, next = 0;
    std::uint32_t device = 0;
    std::uint8_t data_type = 0, time_type = 0;
    double time_s = 0;
  };
  struct Frame {
    std::size_t begin = 0, end = 0;  // the packages, with block headers in between
    double start_time_s = 0, end_time_s = 0;
    int blocks = 0;
  };
  struct Counts;

  void open(const Run& run);
  std::size_t read_header();
  std::optional<Package> package_at(std::size_t at, std::size_t end) const;
  void index_block(std::size_t begin, std::size_t end, Counts& counts);
  void close_frame(Counts& counts);
  void fill_report(Counts& counts);
  const Device* device_of(std::uint32_t id) const;
  double firing_period_s(const Package& package) const;

  std::filesystem::path path_;
  std::string name_;
  FrameSourceOptions options_;
  std::optional<MappedFile> file_;
  Bytes bytes_;
  bool lvx2_ = false;
  double block_s_ = 0.05;
  std::vector<Device> devices_;
  std::vector<Frame> frames_;
  InertialRecord inertial_;
  std::string sensor_ = "unknown", sensor_name_ = "Livox";
  Facts facts_;
  Report report_;
};

}  // namespace bole::io
