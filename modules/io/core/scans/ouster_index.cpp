// How OusterSource finds its frames and inertial samples among the packets.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "io/core/scans/ouster_source.h"

namespace bole::io {
namespace {

constexpr double max_clock_gap_s = 2;  // between the clock of the sensor and that of the recorder

}  // namespace

void OusterSource::index(const Run& run) {
  Counts counts;
  index_packets(run, counts);
  const auto skipped = reader_->skipped();
  // With the default ports, packets of two sensors come to one port.
  if (counts.other_sensor > 0 && counts.other_sensor < counts.data) {
    own_packets_only_ = true;
    counts = {};
    frames_.clear();
    clocks_.clear();
    reader_->seek(begin_);
    index_packets(run, counts);
  }
  counts.skipped = skipped;
  if (frames_.empty())
    throw bad_input(
        "'" + name_ + "' has " + std::to_string(counts.datagrams) + " packets" + " but none with a column of a " +
            decoder_.metadata().model.name + (reader_->trouble().empty() ? "" : " (" + reader_->trouble() + ")"),
        "lidar packets of " + std::to_string(decoder_.lidar_packet_bytes()) + " bytes, as the JSON file says",
        counts.other_port > 0 ? "Lidar packets were seen on another port: set the option port to auto"
                              : "Is the JSON file of this recording?");
  drop_partial_ends();
  sort_inertial(counts);
  fill_report(counts);
}

void OusterSource::index_packets(const Run& run, Counts& counts) {
  const double end = reader_->end();
  const auto poll = [&](std::int64_t offset) {
    run.check_cancel();
    if (end > 0) run.report(static_cast<double>(offset) / end, "indexing packets");
  };
  port_ = options_.port.value_or(0);
  Datagram datagram;
  while (reader_->next(datagram, poll)) {
    if (counts.datagrams++ == 0) begin_ = datagram.offset;
    if (const auto sample = sensor::OusterDecoder::inertial_sample(datagram.payload)) {
      counts.inertial_packets.push_back({*sample, datagram.port, clocks_.empty() ? 0 : clocks_.size() - 1});
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
    if (of_another_sensor(*head)) {
      ++counts.other_sensor;
      if (own_packets_only_) continue;
    }
    ++counts.data;
    if (head->valid_columns == 0) {
      ++counts.empty;
      continue;
    }
    follow_clock(*head, datagram.time_s, counts);
    add(*head, datagram.offset, counts);
  }
}

bool OusterSource::of_another_sensor(const sensor::OusterPacketHead& head) const {
  const auto& serial = decoder_.metadata().serial_number;
  return serial && head.serial_number && *head.serial_number != *serial;
}

void OusterSource::follow_clock(const sensor::OusterPacketHead& head, double recorded_s, Counts& counts) {
  const double sensor_s = 1e-9 * static_cast<double>(head.first_time_ns);
  if (clocks_.empty()) {
    counts.follows_utc = std::abs(sensor_s - recorded_s) < max_clock_gap_s;
    clocks_.push_back({head.first_time_ns, head.last_time_ns, counts.follows_utc ? 0 : recorded_s - sensor_s});
  } else {
    // In captures without usable times the recorder's clock stands still. Then only the sensor's clock counts.
    const double step_s = 1e-9 * static_cast<double>(head.first_time_ns - counts.sensor_ns);
    const double passed_s = recorded_s - counts.recorded_s;
    if (passed_s > 0 && std::abs(step_s) > max_clock_gap_s && std::abs(step_s - passed_s) > max_clock_gap_s) {
      ++counts.clock_jumps;
      clocks_.push_back({head.first_time_ns, head.last_time_ns, clocks_.back().offset_s + passed_s - step_s});
    }
  }
  auto& clock = clocks_.back();
  clock.first_ns = std::min(clock.first_ns, head.first_time_ns);
  clock.last_ns = std::max(clock.last_ns, head.last_time_ns);
  counts.recorded_s = recorded_s;
  counts.sensor_ns = head.first_time_ns;
}

// Frames are numbered modulo 65536. A packet of one of the last frames came late; any other step is a new frame.
void OusterSource::add(const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts) {
  constexpr std::size_t late_frames = 4;
  const std::size_t clock = clocks_.size() - 1;
  const std::size_t first = frames_.size() - std::min(late_frames, frames_.size());
  for (std::size_t i = frames_.size(); i-- > first;) {
    auto& frame = frames_[i];
    const bool last = i + 1 == frames_.size();
    if (frame.id != head.frame_id || frame.clock != clock) continue;
    if (last || head.first_time_ns <= frames_.back().first_time_ns) return add_to(frame, head, offset, counts);
  }
  if (frames_.size() >= late_frames) frames_[first].packet_times_ns = {};
  frames_.push_back({offset,
                     offset,
                     head.frame_id,
                     head.valid_columns,
                     head.first_time_ns,
                     head.last_time_ns,
                     clock,
                     {head.first_time_ns}});
}

void OusterSource::add_to(Frame& frame, const sensor::OusterPacketHead& head, std::int64_t offset, Counts& counts) {
  auto& times = frame.packet_times_ns;
  if (std::ranges::find(times, head.first_time_ns) != times.end()) {
    ++counts.duplicates;
    return;
  }
  times.push_back(head.first_time_ns);
  if (&frame != &frames_.back() || head.last_time_ns < frame.last_time_ns) ++counts.out_of_order;
  frame.begin = std::min(frame.begin, offset);  // a datagram in fragments may end after one that began later
  frame.end = offset;
  frame.columns += head.valid_columns;
  frame.first_time_ns = std::min(frame.first_time_ns, head.first_time_ns);
  frame.last_time_ns = std::max(frame.last_time_ns, head.last_time_ns);
}

// That of the JSON file where packets came to it, else the one to which most came.
int OusterSource::inertial_port(const Counts& counts) const {
  std::map<int, std::size_t> packets;
  for (const auto& c : counts.inertial_packets) ++packets[c.port];
  const auto wanted = decoder_.metadata().imu_port;
  if (packets.empty() || (wanted && packets.contains(*wanted))) return wanted.value_or(0);
  return std::ranges::max_element(packets, {}, [](const auto& p) { return p.second; })->first;
}

// Other packets may be as long as those of the inertial unit (NTP): they have another port, or times that the sensor's
// clock never had.
void OusterSource::sort_inertial(Counts& counts) {
  constexpr std::int64_t margin_ns = 1'000'000'000;
  const auto& metadata = decoder_.metadata();
  auto& samples = inertial_.samples;
  const int port = inertial_port(counts);
  for (const auto& c : counts.inertial_packets) {
    const double sensor_ns = 1e9 * c.sample.time_s;
    const ClockSpan* clock = nullptr;
    for (auto k = c.clock; k < std::min(c.clock + 2, clocks_.size()) && clock == nullptr; ++k)
      if (sensor_ns > static_cast<double>(clocks_[k].first_ns - margin_ns) &&
          sensor_ns < static_cast<double>(clocks_[k].last_ns + margin_ns))
        clock = &clocks_[k];
    if (c.port != port || clock == nullptr) {
      ++counts.inertial_foreign;
      continue;
    }
    samples.push_back(c.sample);
    samples.back().time_s += clock->offset_s;
  }
  counts.inertial = static_cast<std::int64_t>(samples.size());
  std::ranges::stable_sort(samples, {}, &InertialSample::time_s);
  const auto last =
      std::unique(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return !(a.time_s < b.time_s); });
  counts.inertial_twice = samples.end() - last;
  samples.erase(last, samples.end());
  inertial_.T_sensor_imu = metadata.T_sensor_imu;
  inertial_.name = metadata.model.name;
}

// Whole frames between those that were recorded, by the frame ids, but no more than the time between them has room for.
std::int64_t OusterSource::lost_revolutions() const {
  std::vector<std::int64_t> periods_ns;
  for (std::size_t i = 1; i < frames_.size(); ++i)
    if (static_cast<std::uint16_t>(frames_[i].id - frames_[i - 1].id) == 1)
      periods_ns.push_back(frames_[i].first_time_ns - frames_[i - 1].first_time_ns);
  std::int64_t period_ns = 100'000'000;
  if (!periods_ns.empty()) {
    const auto middle = periods_ns.begin() + static_cast<std::ptrdiff_t>(periods_ns.size() / 2);
    std::ranges::nth_element(periods_ns, middle);
    period_ns = std::max<std::int64_t>(1, *middle);
  }
  std::int64_t lost = 0;
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    const auto &a = frames_[i - 1], &b = frames_[i];
    const std::int64_t by_id = static_cast<std::uint16_t>(b.id - a.id) - 1;
    const std::int64_t by_time = (b.first_time_ns - a.first_time_ns + period_ns / 2) / period_ns - 1;
    if (a.clock == b.clock) lost += std::max<std::int64_t>(0, std::min(by_id, by_time));
  }
  return lost;
}

}  // namespace bole::io
