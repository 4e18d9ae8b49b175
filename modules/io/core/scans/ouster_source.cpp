#include "io/core/scans/ouster_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "io/core/scans/beside_capture.h"
#include "io/core/scans/capture_damage.h"
#include "io/core/scans/sensor_facts.h"

namespace bole::io {
namespace {

constexpr double complete_column_share = 0.9;  // of the columns in the window

}  // namespace

OusterSource::OusterSource(std::unique_ptr<DatagramReader> packets, sensor::OusterMetadata metadata,
                           const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run)
    : path_(path),
      name_(path.filename().string()),
      options_(options),
      reader_(std::move(packets)),
      decoder_(std::move(metadata)) {
  index(run);
}

bool OusterSource::is_whole(const Frame& frame) const {
  return frame.columns >= complete_column_share * decoder_.metadata().columns_in_window();
}

void OusterSource::drop_partial_ends() {
  if (options_.keep_partial_frames) return;
  if (frames_.size() > 1 && !is_whole(frames_.back())) frames_.pop_back();
  if (frames_.size() > 1 && !is_whole(frames_.front())) frames_.erase(frames_.begin());
}

void OusterSource::fill_report(const Counts& counts) {
  const auto& metadata = decoder_.metadata();
  const std::int64_t revolutions = lost_revolutions();
  std::int64_t missing = revolutions * metadata.columns_in_window();
  for (const auto& f : frames_) missing += std::max(0, metadata.columns_in_window() - f.columns);
  auto& numbers = report_.counts;
  numbers["frames"] = static_cast<std::int64_t>(frames_.size());
  numbers["data_packets"] = counts.data;
  numbers["inertial_packets"] = counts.inertial;
  numbers["other_packets"] = counts.other + counts.other_port + counts.inertial_foreign + counts.skipped;
  numbers["lost_packets"] = missing / metadata.columns_per_packet;
  numbers["lost_revolutions"] = revolutions;
  numbers["empty_packets"] = counts.empty;
  numbers["duplicate_packets"] = counts.duplicates;
  numbers["clock_jumps"] = counts.clock_jumps;
  numbers["packets_out_of_order"] = counts.out_of_order;
  numbers["incomplete_frames"] = std::ranges::count_if(frames_, [&](const Frame& frame) { return !is_whole(frame); });
  report_.facts["sensor"] = metadata.model.name;
  report_.facts["return_mode"] =
      metadata.profile == sensor::OusterProfile::dual_return || metadata.profile == sensor::OusterProfile::low_rate_dual
          ? "dual"
          : "strongest";
  if (!metadata.return_order.empty()) report_.facts["return_order"] = metadata.return_order;
  report_.facts["clock"] = counts.follows_utc ? "sensor (UTC)" : "recorder, continued by the sensor";
  facts_ = sensor_facts(metadata.model);
  set_fact(facts_, counts.follows_utc ? Clock::utc : Clock::recorder);
  note_damage(*reader_, counts.data, report_);
  if (missing >= metadata.columns_per_packet)
    report_.warn("about " + plural(missing / metadata.columns_per_packet, "packet") + " lost of " +
                 std::to_string(counts.data + missing / metadata.columns_per_packet));
  if (revolutions > 0) report_.warn(plural(revolutions, "whole revolution") + " of the sensor lost");
  if (counts.duplicates > 0)
    report_.warn(plural(counts.duplicates, "lidar packet") + " recorded twice: each is read once");
  if (counts.clock_jumps > 0)
    report_.find(Severity::look, "clock_jumped",
                 "the clock of the sensor was set " + plural(counts.clock_jumps, "time") +
                     " during the recording: times go on without the jump, by the clock of the recorder");
  if (counts.out_of_order > 0) report_.warn(plural(counts.out_of_order, "packet") + " out of order");
  if (counts.other_port > 0)
    report_.warn(plural(counts.other_port, "lidar packet") + " to other UDP ports than " + std::to_string(port_) +
                 " were skipped: choose one with the option port");
  if (counts.other_sensor > 0 && own_packets_only_)
    report_.warn(plural(counts.other_sensor, "packet") + " of a second sensor were left out: those of number " +
                 std::to_string(*metadata.serial_number) + " are read");
  else if (counts.other_sensor > 0)
    report_.find(Severity::look, "calibration_of_another_sensor",
                 plural(counts.other_sensor, "packet") +
                     " of a sensor with another serial number than that in the JSON "
                     "file (" +
                     std::to_string(*metadata.serial_number) +
                     "): its beams are not exact. Take the JSON file of "
                     "this sensor");
  if (metadata.series_assumed)
    report_.warn("the JSON file does not name the product: range noise and beam are those of an " +
                 metadata.model.name + ", by the field of view");
  if (counts.inertial_twice > 0)
    report_.warn(plural(counts.inertial_twice, "inertial sample") + " with the time of another one were left out");
  if (!metadata.legacy_imu && counts.inertial == 0)
    report_.warn(
        "by the JSON file the inertial packets have a profile that is not read, and there are none of the one that is: "
        "set udp_profile_imu to LEGACY before the next recording");
  if (counts.inertial_foreign > 0)
    report_.warn(plural(counts.inertial_foreign, "packet") +
                 " as long as those of the inertial unit, but to another port or with times that its clock never had, "
                 "were left out");
  report_.message = description();
}

std::string OusterSource::description() const {
  return name_ + ": " + plural(static_cast<std::int64_t>(frames_.size()), "frame") + ", " +
         decoder_.metadata().model.name +
         (inertial_.samples.empty()
              ? ""
              : ", " + plural(static_cast<std::int64_t>(inertial_.samples.size()), "inertial sample"));
}

void OusterSource::read(std::size_t index, ScanFrame& frame) const {
  if (index >= frames_.size())
    throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "'",
                    "0 to " + std::to_string(frames_.size() - 1));
  const auto& entry = frames_[index];
  frame.clear();
  frame.start_time_s = seconds(entry, entry.first_time_ns);
  frame.end_time_s = seconds(entry, entry.last_time_ns);
  reader_->seek(entry.begin);
  std::vector<bool> seen(static_cast<std::size_t>(decoder_.metadata().columns_per_frame), false);
  Datagram datagram;
  do {
    if (!reader_->next(datagram))
      throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "' can no longer be read",
                      "the file as it was when it was opened");
    const auto head = decoder_.head(datagram.payload);
    if (!head || datagram.port != port_ || head->frame_id != entry.id || head->valid_columns == 0) continue;
    if (own_packets_only_ && of_another_sensor(*head)) continue;
    returns_.clear();
    decoder_.decode(datagram.payload, returns_);
    // A packet that was recorded twice counts once.
    std::erase_if(returns_, [&](const auto& r) { return seen[r.column]; });
    for (const auto& r : returns_) seen[r.column] = true;
    for (const auto& r : returns_) {
      if (r.range_m < options_.min_range || r.range_m > options_.max_range) continue;
      frame.positions.push_back(r.position);
      frame.time_offset_s.push_back(static_cast<float>(1e-9 * static_cast<double>(r.time_ns - entry.first_time_ns)));
      frame.ring.push_back(r.ring);
      frame.intensity.push_back(r.reflectivity);
      frame.return_number.push_back(r.return_number);
    }
  } while (datagram.offset != entry.end);
}

}  // namespace bole::io
