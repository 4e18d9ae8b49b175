#include "io/core/scans/ouster_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "io/core/scans/capture_damage.h"
#include "io/core/scans/sensor_facts.h"

namespace bole::io {
namespace {

constexpr double complete_share = 0.9;    // of the columns in the window
constexpr double max_disagreement_s = 2;  // between a sensor that follows UTC and the recorder

std::string plural(std::int64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

struct OusterSource::Counts {
  std::int64_t datagrams = 0, data = 0, inertial = 0, other = 0, other_port = 0, empty = 0, out_of_order = 0,
               other_sensor = 0, inertial_dropped = 0;
  bool started = false, follows_utc = false;
};

OusterSource::OusterSource(std::unique_ptr<DatagramReader> packets, sensor::OusterMetadata metadata,
                           const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run)
    : path_(path),
      name_(path.filename().string()),
      options_(options),
      reader_(std::move(packets)),
      decoder_(std::move(metadata)) {
  index(run);
}

void OusterSource::index(const Run& run) {
  const double end = reader_->end();
  const auto poll = [&](std::int64_t offset) {
    run.check_cancel();
    if (end > 0) run.report(static_cast<double>(offset) / end, "indexing packets");
  };
  port_ = options_.port.value_or(0);
  Counts counts;
  Datagram datagram;
  while (reader_->next(datagram, poll)) {
    ++counts.datagrams;
    if (const auto sample = sensor::OusterDecoder::inertial_sample(datagram.payload)) {
      inertial_.samples.push_back(*sample);
      continue;
    }
    const auto head = decoder_.head(datagram.payload);
    if (!head) {
      ++counts.other;
      continue;
    }
    if (port_ == 0) port_ = datagram.port;
    if (datagram.port != port_) {
      ++counts.other_port;
      continue;
    }
    ++counts.data;
    const auto& serial = decoder_.metadata().serial_number;
    if (serial && head->serial_number && *head->serial_number != *serial) ++counts.other_sensor;
    if (head->valid_columns == 0) {
      ++counts.empty;
      continue;
    }
    if (!counts.started) {
      counts.started = true;
      const double sensor_s = 1e-9 * static_cast<double>(head->first_time_ns);
      counts.follows_utc = std::abs(sensor_s - datagram.time_s) < max_disagreement_s;
      clock_offset_s_ = counts.follows_utc ? 0 : datagram.time_s - sensor_s;
    }
    add(*head, datagram.offset, counts);
  }
  if (frames_.empty())
    throw bad_input(
        "'" + name_ + "' has " + plural(counts.datagrams, "packet") + " but none with a column of a " +
            decoder_.metadata().model.name + (reader_->trouble().empty() ? "" : " (" + reader_->trouble() + ")"),
        "lidar packets of " + std::to_string(decoder_.lidar_packet_bytes()) + " bytes, as the JSON file says",
        counts.other_port > 0 ? "Lidar packets were seen on another port: set the option port to auto"
                              : "Is the JSON file of this recording?");
  drop_partial_ends();
  sort_inertial(counts);
  fill_report(counts);
}

// Frames are numbered modulo 65536. A packet of one of the last frames came late; any other step is a new frame.
void OusterSource::add(const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts) {
  constexpr std::size_t late_frames = 4;
  if (!frames_.empty() && frames_.back().id != head.frame_id) {
    const std::size_t first = frames_.size() - std::min(late_frames, frames_.size());
    for (std::size_t i = first; i + 1 < frames_.size(); ++i) {
      auto& frame = frames_[i];
      if (frame.id != head.frame_id || head.first_time_ns > frames_.back().first_time_ns) continue;
      ++counts.out_of_order;
      frame.begin = std::min(frame.begin, offset);
      frame.end = offset;
      frame.columns += head.valid_columns;
      frame.first_time_ns = std::min(frame.first_time_ns, head.first_time_ns);
      frame.last_time_ns = std::max(frame.last_time_ns, head.last_time_ns);
      return;
    }
  }
  if (frames_.empty() || frames_.back().id != head.frame_id) {
    frames_.push_back({offset, offset, head.frame_id, head.valid_columns, head.first_time_ns, head.last_time_ns});
    return;
  }
  auto& frame = frames_.back();
  if (head.last_time_ns < frame.last_time_ns) ++counts.out_of_order;
  frame.begin = std::min(frame.begin, offset);  // a datagram in fragments may end after one that began later
  frame.end = offset;
  frame.columns += head.valid_columns;
  frame.first_time_ns = std::min(frame.first_time_ns, head.first_time_ns);
  frame.last_time_ns = std::max(frame.last_time_ns, head.last_time_ns);
}

void OusterSource::sort_inertial(Counts& counts) {
  counts.inertial = static_cast<std::int64_t>(inertial_.samples.size());
  auto& samples = inertial_.samples;
  for (auto& s : samples) s.time_s += clock_offset_s_;
  std::ranges::stable_sort(samples, {}, &InertialSample::time_s);
  const auto last =
      std::unique(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return !(a.time_s < b.time_s); });
  counts.inertial_dropped = samples.end() - last;
  samples.erase(last, samples.end());
  inertial_.T_sensor_imu = decoder_.metadata().T_sensor_imu;
  inertial_.name = decoder_.metadata().model.name;
}

bool OusterSource::is_whole(const Frame& frame) const {
  return frame.columns >= complete_share * decoder_.metadata().columns_in_window();
}

void OusterSource::drop_partial_ends() {
  if (options_.keep_partial_frames) return;
  if (frames_.size() > 1 && !is_whole(frames_.back())) frames_.pop_back();
  if (frames_.size() > 1 && !is_whole(frames_.front())) frames_.erase(frames_.begin());
}

void OusterSource::fill_report(const Counts& counts) {
  const auto& metadata = decoder_.metadata();
  std::int64_t missing = 0;
  for (const auto& f : frames_) missing += std::max(0, metadata.columns_in_window() - f.columns);
  auto& numbers = report_.counts;
  numbers["frames"] = static_cast<std::int64_t>(frames_.size());
  numbers["data_packets"] = counts.data;
  numbers["inertial_packets"] = counts.inertial;
  numbers["other_packets"] = counts.other + counts.other_port + reader_->skipped();
  numbers["lost_packets"] = missing / metadata.columns_per_packet;
  numbers["packets_out_of_order"] = counts.out_of_order;
  numbers["incomplete_frames"] = std::ranges::count_if(frames_, [&](const Frame& frame) { return !is_whole(frame); });
  report_.facts["sensor"] = metadata.model.name;
  report_.facts["return_mode"] =
      metadata.profile == sensor::OusterProfile::dual_return || metadata.profile == sensor::OusterProfile::low_rate_dual
          ? "dual"
          : "strongest";
  report_.facts["clock"] = counts.follows_utc ? "sensor (UTC)" : "recorder, continued by the sensor";
  facts_ = sensor_facts(metadata.model);
  set_fact(facts_, counts.follows_utc ? Clock::utc : Clock::recorder);
  note_damage(*reader_, counts.data, report_);
  if (missing >= metadata.columns_per_packet)
    report_.warn("about " + plural(missing / metadata.columns_per_packet, "packet") + " lost of " +
                 std::to_string(counts.data + missing / metadata.columns_per_packet));
  if (counts.out_of_order > 0) report_.warn(plural(counts.out_of_order, "packet") + " out of order");
  if (counts.other_port > 0)
    report_.warn(plural(counts.other_port, "lidar packet") + " to other UDP ports than " + std::to_string(port_) +
                 " were skipped: choose one with the option port");
  if (counts.other_sensor > 0)
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
  if (counts.inertial_dropped > 0)
    report_.warn(plural(counts.inertial_dropped, "inertial sample") + " with the time of another one were left out");
  if (!metadata.legacy_imu && counts.inertial == 0)
    report_.warn("the sensor sent inertial packets of a profile that is not read: set udp_profile_imu to LEGACY");
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
  frame.start_time_s = seconds(entry.first_time_ns);
  frame.end_time_s = seconds(entry.last_time_ns);
  reader_->seek(entry.begin);
  std::vector<bool> seen(static_cast<std::size_t>(decoder_.metadata().columns_per_frame), false);
  Datagram datagram;
  do {
    if (!reader_->next(datagram))
      throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "' can no longer be read",
                      "the file as it was when it was opened");
    const auto head = decoder_.head(datagram.payload);
    if (!head || datagram.port != port_ || head->frame_id != entry.id || head->valid_columns == 0) continue;
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
