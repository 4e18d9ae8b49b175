// Frames of a bag whose messages are point clouds: sensor_msgs/PointCloud2 and the CustomMsg of the Livox drivers.
#pragma once

#include <memory>
#include <optional>

#include "cloud/core/index_times.h"
#include "io/core/bags/bag.h"
#include "io/core/bags/ring_order.h"
#include "io/core/bags/time_dialect.h"
#include "io/core/scans/frame_source.h"
#include "sensor/core/sensor_model.h"

namespace bole::io {

// One message is one frame. Messages are decoded when they are read; a few, spread over the recording, are looked at
// when it is opened, to find the unit and the origin of the times, the order of the rings and the scale of the
// intensities.
class BagCloudSource : public FrameSource, public IndexTimes {
 public:
  // Throws Error{bad_input} where no message of the topic can be read.
  BagCloudSource(std::shared_ptr<const Bag> bag, std::size_t topic, const std::filesystem::path& path,
                 const FrameSourceOptions& options, const Run& run);

  std::size_t size() const override { return messages_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override;
  double frame_time_s(std::size_t index) const override;
  double index_time_s(std::size_t index) const override;
  int rings() const override;
  ScanPattern pattern() const override { return rosette_ ? ScanPattern::rosette : ScanPattern::lines; }
  std::vector<double> ring_elevations_rad() const override { return elevations_rad_; }
  std::string sensor_model() const override { return model_ ? model_->id : "unknown"; }
  Facts facts() const override { return facts_; }
  std::string description() const override;
  std::string locator() const override { return frame_source_locator(path_, options_); }

  const Report& report() const { return report_; }

 private:
  struct Sample {
    RawPoints points;
    std::int64_t recorded_ns = 0;
  };
  std::vector<Sample> read_samples(const Run& run);
  void decode(std::size_t index, RawPoints& points) const;
  void learn_times(const std::vector<Sample>& samples);
  void learn_livox_clock(const std::vector<Sample>& samples);
  void learn_rings(const std::vector<RawPoints>& samples);
  void learn_intensity(const std::vector<RawPoints>& samples);
  void learn_tags(const std::vector<RawPoints>& samples);
  void learn_index_times(const std::vector<Sample>& samples);
  void check_axes(const std::vector<RawPoints>& samples);
  double start_time_s(std::size_t index) const;
  void set_times(const RawPoints& points, ScanFrame& frame) const;
  void set_rings(const RawPoints& points, ScanFrame& frame) const;

  std::shared_ptr<const Bag> bag_;
  BagTopic topic_;
  std::filesystem::path path_;
  FrameSourceOptions options_;
  std::vector<BagMessage> messages_;
  std::optional<sensor::SensorModel> model_;
  std::optional<CloudLayout> layout_;  // of the samples; nothing for Livox messages
  TimeDialect times_;
  double period_s_ = 0.1;
  bool starts_at_stamp_ = false, times_by_order_ = false;
  RingOrder ring_order_;
  bool rosette_ = false, rings_by_order_ = false;
  bool tags_number_returns_ = true;
  std::optional<double> index_shift_s_;  // from the time of recording to the start of the frame, where it is constant
  float intensity_factor_ = 1;
  std::vector<double> elevations_rad_;
  Facts facts_;
  Report report_;
  mutable std::vector<double> start_times_s_;  // NaN until they are asked for
  mutable RawPoints scratch_;
  mutable LivoxMessage livox_;
};

}  // namespace bole::io
