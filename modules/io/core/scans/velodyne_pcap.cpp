#include "io/core/scans/velodyne_pcap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "io/core/scans/beside_capture.h"
#include "io/core/scans/calibration_beside.h"
#include "io/core/scans/capture_damage.h"
#include "io/core/scans/pcap_reader.h"
#include "io/core/scans/sensor_facts.h"

namespace bole::io {
namespace {

constexpr double full_turn = 36000;
constexpr double complete_share = 0.9;  // of the angle that most frames cover
constexpr double max_loss_s = 60;       // a longer silence is a pause of the recording

std::string product_text(const sensor::VelodynePacket& packet) {
  char text[64];
  std::snprintf(text, sizeof text, "product id 0x%02X, return mode 0x%02X", packet.product_id, packet.return_mode);
  return text;
}

}  // namespace

// Goes through the firings of the whole recording and marks where frames begin and end.
class VelodynePcapSource::Indexer {
 public:
  Indexer(VelodynePcapSource& source, double cut_centideg) : source_(source), cut_centideg_(cut_centideg) {}

  void add(const Datagram& datagram) {
    const bool first = !last_past_hour_us_;
    const double previous_time_s = packet_time_s_;
    const auto& decoder = *source_.decoder_;
    packet_time_s_ = clock_.time_s(decoder.past_hour_us(), datagram.time_s);
    if (clock_.jumped()) {
      ++clock_jumps;
      break_ = true;
    }
    if (!first && !clock_.jumped()) count_order(previous_time_s);
    last_past_hour_us_ = decoder.past_hour_us();
    decoder.firings(firings_);
    packet_end_s_ = std::max(packet_end_s_, packet_time_s_ + firings_.back().time_offset_s + decoder.firing_period_s());
    if (first || clock_.jumped())
      packet_end_s_ = packet_time_s_ + firings_.back().time_offset_s + decoder.firing_period_s();
    // The time that the rotor takes to pass a masked sector is known to a few percent only.
    slack_s_ = 0.05 * (firings_.back().time_offset_s + decoder.firing_period_s() - decoder.packet_period_s());
    for (std::size_t i = 0; i < firings_.size(); ++i) {
      const auto& firing = firings_[i];
      if (!firing.valid) continue;
      advance(firing);
      if (source_.frames_.empty() || starts_frame_) {
        source_.frames_.push_back({{datagram.offset, i},
                                   {},
                                   packet_time_s_ + firing.time_offset_s,
                                   packet_time_s_,
                                   decoder.past_hour_us(),
                                   0});
        starts_frame_ = false;
      }
      auto& frame = source_.frames_.back();
      frame.end = {datagram.offset, i + 1};
      frame.turned_centideg += std::abs(firing.advance_centideg);
    }
  }

  bool follows_utc() const { return clock_.follows_utc(); }
  std::int64_t lost = 0, out_of_order = 0, clock_jumps = 0;

 private:
  void count_order(double previous_time_s) {
    const double period_s = source_.decoder_->packet_period_s();
    const double silence_s = packet_time_s_ - packet_end_s_;
    if (packet_time_s_ < previous_time_s) {
      ++out_of_order;
    } else if (silence_s > 0.5 * period_s + slack_s_ && silence_s < max_loss_s) {
      lost += std::llround(silence_s / period_s);
    }
  }

  // Follows the rotor from firing to firing. The azimuth gives its position, the time the number of whole revolutions.
  void advance(const sensor::VelodyneFiring& firing) {
    const double time_s = packet_time_s_ + firing.time_offset_s;
    double relative = std::fmod(firing.azimuth_centideg - cut_centideg_ + 2 * full_turn, full_turn);
    if (started_ && !break_) {
      const double expected = rate_centideg_s_ * (time_s - last_time_s_);
      const double observed = relative - last_relative_;
      const double moved = observed + full_turn * std::nearbyint((expected - observed) / full_turn);
      starts_frame_ = starts_frame_ || last_relative_ + moved >= full_turn;
      if (last_relative_ + moved < 0 && moved > -full_turn / 2)
        relative = 0;  // a late packet from before the cut angle
    } else if (started_) {
      starts_frame_ = true;
    }
    if (firing.advance_centideg > 0) rate_centideg_s_ = firing.advance_centideg / source_.decoder_->firing_period_s();
    started_ = true;
    break_ = false;
    last_relative_ = relative;
    last_time_s_ = time_s;
  }

  VelodynePcapSource& source_;
  double cut_centideg_;
  PacketClock clock_;
  std::vector<sensor::VelodyneFiring> firings_;
  std::optional<std::uint32_t> last_past_hour_us_;
  double packet_time_s_ = 0, packet_end_s_ = 0, slack_s_ = 0, last_time_s_ = 0, last_relative_ = 0,
         rate_centideg_s_ = 0;
  bool started_ = false, starts_frame_ = false, break_ = false;
};

VelodynePcapSource::VelodynePcapSource(const std::filesystem::path& path, const FrameSourceOptions& options,
                                       const Run& run)
    : VelodynePcapSource(std::make_unique<PcapReader>(path), path, options, run) {}

VelodynePcapSource::VelodynePcapSource(Bytes capture, const std::string& name, const FrameSourceOptions& options,
                                       const Run& run)
    : VelodynePcapSource(std::make_unique<PcapReader>(capture, name), name, options, run) {}

VelodynePcapSource::VelodynePcapSource(std::unique_ptr<DatagramReader> packets, const std::filesystem::path& path,
                                       const FrameSourceOptions& options, const Run& run,
                                       std::unique_ptr<sensor::PacketDecoder> decoder)
    : path_(path),
      name_(path.filename().string()),
      options_(options),
      reader_(std::move(packets)),
      decoder_(std::move(decoder)) {
  index(run);
}

void VelodynePcapSource::index(const Run& run) {
  if (!decoder_ && options_.sensor != "auto") decode_as(sensor::load_sensor_model(options_.sensor));
  port_ = options_.port.value_or(0);
  const double end = reader_->end();
  Indexer indexer(*this, options_.cut_angle_deg * 100);
  auto& counts = report_.counts;
  std::int64_t datagrams = 0, data_packets = 0, position_packets = 0, other_port = 0, other = 0;
  Datagram datagram;
  const auto poll = [&](std::int64_t offset) {
    run.check_cancel();
    if (end > 0) run.report(static_cast<double>(offset) / end, "indexing packets");
  };
  while (reader_->next(datagram, poll)) {
    ++datagrams;
    if (datagram.payload.size() == 554 || datagram.payload.size() == 512) {
      ++position_packets;
      continue;
    }
    if (!decoder_) recognise(datagram.payload);
    if (!decoder_ || !decoder_->take(datagram.payload)) {
      ++other;
      continue;
    }
    if (port_ == 0) port_ = datagram.port;
    if (datagram.port != port_) {
      ++other_port;
      continue;
    }
    if (data_packets++ == 0) report_.facts["return_mode"] = decoder_->return_mode();
    indexer.add(datagram);
  }
  if (data_packets == 0) {
    const std::string port_text = options_.port ? " to UDP port " + std::to_string(*options_.port) : "";
    throw bad_input("'" + name_ + "' has " + plural(datagrams, "UDP datagram") + " but no Velodyne data packet" +
                        port_text + (reader_->trouble().empty() ? "" : " (" + reader_->trouble() + ")"),
                    "datagrams of 1206 bytes",
                    other_port > 0 ? "Data packets were seen on another port: set the option port to auto"
                                   : "Is this the recording of a Velodyne sensor?");
  }
  if (frames_.empty())
    throw bad_input("'" + name_ + "' has " + plural(data_packets, "data packet") + " whose blocks are all damaged",
                    "data packets of a " + decoder_->model().name);
  drop_partial_ends();
  const double complete_turn = usual_turn_centideg() * complete_share;
  counts["frames"] = static_cast<std::int64_t>(frames_.size());
  counts["data_packets"] = data_packets;
  counts["position_packets"] = position_packets;
  counts["other_packets"] = other + other_port + reader_->skipped();
  counts["lost_packets"] = indexer.lost;
  counts["packets_out_of_order"] = indexer.out_of_order;
  counts["incomplete_frames"] =
      std::count_if(frames_.begin(), frames_.end(), [&](const Frame& f) { return f.turned_centideg < complete_turn; });
  report_.facts["sensor"] = decoder_->model().name;
  facts_ = sensor_facts(decoder_->model());
  set_fact(facts_, indexer.follows_utc() ? Clock::utc : Clock::recorder);
  report_.facts["clock"] = indexer.follows_utc() ? "sensor (UTC)" : "capture, continued by the sensor";
  note_damage(*reader_, data_packets, report_);
  if (indexer.lost > 0)
    report_.warn("about " + plural(indexer.lost, "packet") + " lost of " + std::to_string(data_packets + indexer.lost));
  if (indexer.out_of_order > 0) report_.warn(plural(indexer.out_of_order, "packet") + " out of order");
  if (indexer.clock_jumps > 0)
    report_.warn("the sensor's clock was set " + plural(indexer.clock_jumps, "time") +
                 " during the recording; times continue without the jump");
  if (other_port > 0)
    report_.warn(plural(other_port, "data packet") + " to other UDP ports than " + std::to_string(port_) +
                 " were skipped: choose one with the option port");
  report_.message = description();
}

void VelodynePcapSource::recognise(Bytes payload) {
  const auto packet = sensor::parse_velodyne_packet(payload);
  if (!packet) return;
  auto model = sensor::recognise_velodyne(*packet);
  if (!model)
    throw bad_input(
        "'" + name_ + "' holds packets of a Velodyne sensor that is not known (" + product_text(*packet) + ")",
        "VLP-16, VLP-32C, VLS-128, HDL-32E or HDL-64E", "Name the sensor with the option sensor");
  std::optional<sensor::SensorModel> foreign;
  if (auto own = calibration_beside(path_, *model, foreign)) {
    report_.facts["calibration"] = own->file.filename().string();
    model = std::move(own);
  } else if (foreign) {
    report_.find(Severity::look, "calibration_of_another_sensor",
                 "'" + foreign->file.filename().string() + "' calibrates a " + foreign->name +
                     ", the capture is of a " + model->name + ": it was left out");
  } else if (model->channels.size() == 64) {
    report_.find(Severity::look, "sensor_not_calibrated",
                 "every " + model->name + " is wired and calibrated by itself, and no calibration lies beside '" +
                     name_ +
                     "': points may be decimetres off. Put the calibration of the unit (db.xml, or YAML of ROS) beside "
                     "the capture");
  }
  decode_as(std::move(*model));
}

void VelodynePcapSource::decode_as(sensor::SensorModel model) {
  if (sensor::has_laser_heights(model)) {
    report_.facts["laser_heights"] = options_.laser_heights ? "added" : "left out";
    if (!options_.laser_heights) model = sensor::without_laser_heights(std::move(model));
  }
  decoder_ = std::make_unique<sensor::VelodynePackets>(std::move(model));
}

// A full revolution, or less where the sensor masks a sector.
double VelodynePcapSource::usual_turn_centideg() const {
  if (frames_.size() < 3) return full_turn;
  std::vector<double> turns;
  for (const auto& f : frames_) turns.push_back(f.turned_centideg);
  std::ranges::nth_element(turns, turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2));
  return turns[turns.size() / 2];
}

void VelodynePcapSource::drop_partial_ends() {
  if (options_.keep_partial_frames || frames_.size() < 2) return;
  const double complete_turn = usual_turn_centideg() * complete_share;
  if (frames_.back().turned_centideg < complete_turn) frames_.pop_back();
  if (frames_.size() > 1 && frames_.front().turned_centideg < complete_turn) frames_.erase(frames_.begin());
}

std::string VelodynePcapSource::description() const {
  return name_ + ": " + plural(static_cast<std::int64_t>(frames_.size()), "frame") + ", " + decoder_->model().name;
}

bool VelodynePcapSource::next_packet(Datagram& datagram) const {
  while (reader_->next(datagram))
    if (datagram.port == port_ && decoder_->take(datagram.payload)) return true;
  return false;
}

void VelodynePcapSource::append(const sensor::VelodyneReturn& r, double packet_offset_s, ScanFrame& frame) const {
  if (r.range_m < options_.min_range || r.range_m > options_.max_range) return;
  frame.positions.push_back(r.position);
  frame.time_offset_s.push_back(static_cast<float>(packet_offset_s + r.time_offset_s));
  frame.ring.push_back(r.ring);
  frame.intensity.push_back(r.intensity);
  frame.return_number.push_back(r.return_number);
}

void VelodynePcapSource::read(std::size_t index, ScanFrame& frame) const {
  if (index >= frames_.size())
    throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "'",
                    "0 to " + std::to_string(frames_.size() - 1));
  const auto& entry = frames_[index];
  frame.clear();
  frame.start_time_s = entry.start_time_s;
  reader_->seek(entry.begin.offset);
  Datagram datagram;
  double last_offset_s = 0;
  do {
    if (!next_packet(datagram))
      throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "' can no longer be read",
                      "the file as it was when it was opened");
    const double packet_offset_s =
        entry.packet_time_s - entry.start_time_s +
        1e-6 * static_cast<double>(past_hour_difference_us(entry.past_hour_us, decoder_->past_hour_us()));
    decoder_->firings(firings_);
    const std::size_t first = datagram.offset == entry.begin.offset ? entry.begin.firing : 0;
    const std::size_t last = datagram.offset == entry.end.offset ? entry.end.firing : firings_.size();
    returns_.clear();
    decoder_->decode(firings_, first, last, returns_);
    for (const auto& r : returns_) append(r, packet_offset_s, frame);
    if (last > 0 && last <= firings_.size())
      last_offset_s = std::max(last_offset_s, packet_offset_s + firings_[last - 1].time_offset_s);
  } while (datagram.offset < entry.end.offset);
  frame.end_time_s = frame.start_time_s + last_offset_s;
}

}  // namespace bole::io
