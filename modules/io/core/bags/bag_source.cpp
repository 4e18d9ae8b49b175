#include "io/core/bags/bag_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/option.h"
#include "base/verdict.h"
#include "cloud/core/index_times.h"
#include "io/core/bags/bag_clouds.h"
#include "io/core/bags/bag_inertial.h"
#include "io/core/bags/bag_ouster.h"
#include "io/core/bags/bag_packets.h"
#include "io/core/bags/bag_topics.h"
#include "io/core/scans/ouster_source.h"
#include "io/core/scans/velodyne_pcap.h"

namespace bole::io {
namespace {

// Frames of a topic, and the inertial unit of another one.
class FramesWithInertial : public FrameSource, public IndexTimes {
 public:
  FramesWithInertial(std::shared_ptr<const FrameSource> frames, BagInertial inertial)
      : frames_(std::move(frames)), inertial_(std::move(inertial)) {}

  std::size_t size() const override { return frames_->size(); }
  void read(std::size_t index, ScanFrame& frame) const override { frames_->read(index, frame); }
  double frame_time_s(std::size_t index) const override { return frames_->frame_time_s(index); }
  double index_time_s(std::size_t index) const override { return cloud::index_time_s(*frames_, index); }
  int rings() const override { return frames_->rings(); }
  ScanPattern pattern() const override { return frames_->pattern(); }
  const InertialRecord* inertial() const override {
    const auto* record = inertial_.record();
    return record->samples.empty() ? nullptr : record;
  }
  std::vector<double> ring_elevations_rad() const override { return frames_->ring_elevations_rad(); }
  std::string sensor_model() const override { return frames_->sensor_model(); }
  Facts facts() const override { return frames_->facts(); }
  std::string description() const override { return frames_->description(); }
  std::string locator() const override { return frames_->locator(); }

 private:
  std::shared_ptr<const FrameSource> frames_;
  BagInertial inertial_;
};

bool names_file(const std::string& imu) {
  std::error_code ignored;
  const auto ending = std::filesystem::path(imu).extension();
  return ending == ".csv" || ending == ".txt" || std::filesystem::is_regular_file(imu, ignored);
}

template <class Source, class... More>
std::shared_ptr<const FrameSource> open_packets(std::unique_ptr<BagPackets> packets, Report& report, More&&... more) {
  const auto& reader = *packets;  // lives as long as the source
  auto source = std::make_shared<const Source>(std::move(packets), std::forward<More>(more)...);
  report = source->report();
  if (reader.damaged_messages() > 0)
    report.find(
        Severity::look, "input_damaged",
        std::to_string(reader.damaged_messages()) + " messages of packets cannot be read (" + reader.damage() + ")");
  return source;
}

std::shared_ptr<const FrameSource> open_topic(const std::shared_ptr<const Bag>& bag, std::size_t topic,
                                              const std::filesystem::path& path, const FrameSourceOptions& options,
                                              const Run& run, Report& report) {
  const auto& chosen = bag->topics()[topic];
  std::shared_ptr<const FrameSource> source;
  std::string calibration;
  if (chosen.type == message_type::velodyne) {
    auto packets = std::make_unique<BagPackets>(bag, std::vector{topic}, run);
    source = open_packets<VelodynePcapSource>(std::move(packets), report, path, options, run);
  } else if (holds_ouster_packets(chosen)) {
    auto metadata = find_ouster_metadata(*bag, path, options.sensor, run, calibration);
    auto packets = std::make_unique<BagPackets>(bag, ouster_topics(*bag, topic), run);
    source = open_packets<OusterSource>(std::move(packets), report, std::move(metadata), path, options, run);
    report.facts["calibration"] = calibration;
  } else {
    auto clouds = std::make_shared<const BagCloudSource>(bag, topic, path, options, run);
    report = clouds->report();
    source = std::move(clouds);
  }
  report.facts["topic"] = chosen.name + " (" + chosen.type + ")";
  return source;
}

constexpr double max_uncovered = 0.02;  // of the time of the scan

// The unit measures on the clock of the frames, or it cannot be used with them.
void compare_clocks(const FrameSource& frames, const BagInertial& inertial, Report& report) {
  const double first_s = frames.frame_time_s(0), last_s = frames.frame_time_s(frames.size() - 1);
  if (inertial.first_s() > last_s || inertial.last_s() < first_s)
    report.find(Severity::look, "imu_clock_differs",
                "the stamps of the inertial unit and of the scan do not overlap (they begin " +
                    std::to_string(std::llround(inertial.first_s() - first_s)) +
                    " s apart): the two have different clocks, and the unit cannot be used");
  else if (const double without_s =
               std::max(0.0, inertial.first_s() - first_s) + std::max(0.0, last_s - inertial.last_s());
           without_s > std::max(1.0, max_uncovered * (last_s - first_s)))
    report.find(Severity::look, "imu_covers_part",
                number_text(std::round(10 * without_s) / 10) + " s of the scan, of " +
                    number_text(std::round(10 * (last_s - first_s)) / 10) +
                    " s, have no measurement of the inertial unit: was it started with the scanner, and are the "
                    "clocks the same?");
}

}  // namespace

std::shared_ptr<const FrameSource> open_bag_source(const std::shared_ptr<const Bag>& bag,
                                                   const std::filesystem::path& path, const FrameSourceOptions& options,
                                                   const Run& run, Report& report) {
  const auto topic = choose_scan_topic(*bag, options.topic);
  auto source = open_topic(bag, topic, path, options, run, report);
  const bool own_unit = options.imu.empty() && source->inertial() != nullptr;
  if (options.imu != "none" && !names_file(options.imu) && !own_unit) {
    std::string several;
    if (const auto imu = choose_imu_topic(*bag, options.imu, several)) try {
        BagInertial inertial(bag, *imu, run, report);
        compare_clocks(*source, inertial, report);
        source = std::make_shared<const FramesWithInertial>(std::move(source), std::move(inertial));
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::bad_input || !options.imu.empty()) throw;
        report.warn("the inertial unit is left out: " + e.found());
      }
    if (!several.empty())
      report.warn("the recording has more than one inertial unit: " + several +
                  ". None is used; name one with the option imu");
  }
  constexpr double whole_enough = 0.99;
  for (const auto& text : bag->damage()) report.find(Severity::look, "input_damaged", text);
  if (bag->lost_share() > 1 - whole_enough)
    report.find(Severity::refused, finding_code::input_incomplete,
                std::to_string(std::lround(100 * bag->lost_share())) + " % of the recording cannot be read");
  return source;
}

std::shared_ptr<const FrameSource> open_bag_source(const std::filesystem::path& path, const FrameSourceOptions& options,
                                                   const Run& run, Report& report) {
  return open_bag_source(std::shared_ptr<const Bag>(open_bag(path, run)), path, options, run, report);
}

}  // namespace bole::io
