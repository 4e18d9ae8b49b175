#include "io/core/bags/bag_clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/file_pages.h"
#include "base/option.h"
#include "io/core/bags/message_order.h"
#include "io/core/scans/frame_estimates.h"
#include "io/core/scans/sensor_facts.h"

namespace bole::io {
namespace {

constexpr std::size_t sampled_frames = 9;
// Of the period: a driver may give the first points of a frame times slightly before its start.
constexpr double early_share = 0.01;

double seconds(std::int64_t ns) { return 1e-9 * static_cast<double>(ns); }

}  // namespace

BagCloudSource::BagCloudSource(std::shared_ptr<const Bag> bag, std::size_t topic, const std::filesystem::path& path,
                               const FrameSourceOptions& options, const Run& run)
    : bag_(std::move(bag)),
      topic_(bag_->topics()[topic]),
      path_(path),
      options_(options),
      messages_(bag_->index(topic, run)) {
  if (messages_.empty()) throw bad_input("topic " + topic_.name + " has no messages", "messages of " + topic_.type);
  check_order(*bag_, topic_, messages_, run, report_);
  start_times_s_.assign(messages_.size(), std::numeric_limits<double>::quiet_NaN());
  period_s_ = usual_period_s(messages_);
  rosette_ = topic_.type != message_type::cloud;
  auto samples = read_samples(run);
  learn_times(samples);
  learn_index_times(samples);
  std::vector<RawPoints> points;
  for (auto& sample : samples) points.push_back(std::move(sample.points));
  if (options_.sensor != "auto") model_ = sensor::load_sensor_model(options_.sensor);
  if (model_) facts_.merge(sensor_facts(*model_));
  learn_rings(points);
  learn_intensity(points);
  learn_tags(points);
  check_axes(points);
  report_.counts["frames"] = static_cast<std::int64_t>(messages_.size());
  report_.facts["topic"] = topic_.name + " (" + topic_.type + ")";
  report_.facts["sensor"] =
      model_ ? model_->name : "unknown, " + (rosette_ ? "rosette" : std::to_string(rings()) + " rings");
  if (!model_)
    report_.warn(
        "the recording does not say which sensor it is from: beam and range noise are not known. Name it with "
        "the option sensor");
  report_.message = description();
}

std::vector<BagCloudSource::Sample> BagCloudSource::read_samples(const Run& run) {
  std::vector<Sample> samples;
  std::string trouble;
  const auto count = std::min(sampled_frames, messages_.size());
  for (std::size_t k = 0; k < count; ++k) {
    run.check_cancel();
    const auto index = count == 1 ? 0 : k * (messages_.size() - 1) / (count - 1);
    try {
      Sample sample;
      decode(index, sample.points);
      sample.recorded_ns = messages_[index].time_ns;
      if (!layout_ && topic_.type == message_type::cloud)
        layout_ = layout_of(parse_cloud(bag_->read(messages_[index]), topic_.encoding).fields);
      if (sample.points.positions.empty()) continue;
      samples.push_back(std::move(sample));
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      if (trouble.empty()) trouble = e.found();
    }
  }
  if (samples.empty())
    throw bad_input("no message of topic " + topic_.name + " holds a point within min_range and max_range" +
                        (trouble.empty() ? "" : " (" + trouble + ")"),
                    "messages of " + topic_.type);
  return samples;
}

void BagCloudSource::decode(std::size_t index, RawPoints& points) const {
  const auto bytes = bag_->read(messages_[index]);
  if (topic_.type == message_type::cloud) {
    const auto message = parse_cloud(bytes, topic_.encoding);
    auto layout = layout_of(message.fields);
    if (times_by_order_) layout.time.reset();
    read_cloud_points(message, layout, points);
  } else {
    parse_livox(bytes, topic_.encoding, livox_);
    read_livox_points(livox_, points);
    if (times_.from_base) points.stamp_ns = points.base_ns;
  }
  leave_memory(bytes.data(), bytes.size());
  keep_valid(points, options_.min_range, options_.max_range);
}

void BagCloudSource::learn_times(const std::vector<Sample>& samples) {
  std::vector<TimeSample> seen;
  for (const auto& sample : samples)
    if (const auto s = time_sample(sample.points, sample.recorded_ns)) seen.push_back(*s);
  if (rosette_) {
    learn_livox_clock(samples);
  } else if (!seen.empty()) {
    times_ = find_time_dialect(layout_->time, seen, period_s_);
  } else {
    times_.text = "none";
  }
  if (times_.origin == TimeOrigin::none && layout_ && layout_->livox) {
    times_by_order_ = true;
    times_.origin = TimeOrigin::after_stamp;
    times_.unit_s = period_s_;
    times_.text = "none: by the order of the points";
    report_.warn(
        "the points have no times: they follow from the order of the points, evenly over the time between two "
        "messages, from the stamp of the message");
  }
  starts_at_stamp_ = times_.origin == TimeOrigin::after_stamp && std::ranges::all_of(seen, [this](const auto& s) {
                       return s.first * times_.unit_s > -early_share * period_s_;
                     });
  report_.facts["point_times"] = times_.text;
  if (!times_.warning.empty()) report_.find(Severity::look, "point_times_unclear", times_.warning);
  if (times_.origin == TimeOrigin::none)
    report_.warn(
        "the points have no times: they follow from their azimuths, for a clockwise sensor that starts behind "
        "and faces forward at the stamp of the message (as in KITTI)");
  set_fact(facts_, Clock::recorder);
  report_.facts["clock"] = "stamps of the messages";
}

void BagCloudSource::learn_livox_clock(const std::vector<Sample>& samples) {
  double apart_s = 0;
  for (const auto& s : samples)
    apart_s = std::max(apart_s,
                       1e-9 * std::abs(static_cast<double>(s.points.base_ns) - static_cast<double>(s.points.stamp_ns)));
  times_ = livox_dialect(apart_s, period_s_);
}

void BagCloudSource::learn_rings(const std::vector<RawPoints>& samples) {
  if (rosette_ || (layout_ && layout_->livox)) {
    rosette_ = true;
    report_.facts["rings"] = "none: the beams draw a rosette";
    return;
  }
  ring_order_ = RingOrder::learn(samples);
  if (!ring_order_.empty()) {
    elevations_rad_ = ring_order_.elevations_rad();
    report_.facts["rings"] = ring_order_.text();
    if (model_ && model_->rings() == ring_order_.rings()) elevations_rad_ = model_->ring_elevations_rad();
    if (model_ && model_->rings() < ring_order_.rings())
      report_.find(Severity::look, "sensor_does_not_fit",
                   "the points have " + std::to_string(ring_order_.rings()) + " rings, and the sensor " + model_->name +
                       " has " + std::to_string(model_->rings()) + ": is the option sensor right?");
    return;
  }
  if (model_) {
    elevations_rad_ = model_->ring_elevations_rad();
    report_.facts["rings"] = "by the elevations of the sensor";
    return;
  }
  const auto most = std::ranges::max_element(samples, {}, [](const RawPoints& p) { return p.positions.size(); });
  if (const auto rings = rings_from_order(most->positions); !rings.empty()) {
    rings_by_order_ = true;
    elevations_rad_ = mean_elevations_rad(most->positions, rings);
    report_.facts["rings"] = "from the order of the points";
    return;
  }
  elevations_rad_ = even_elevations_rad(most->positions, options_.rings);
  report_.facts["rings"] = "from elevations";
  report_.warn("the points have no rings: " + std::to_string(options_.rings) +
               " evenly spaced ones are assumed. Name the sensor with the option sensor");
}

void BagCloudSource::learn_intensity(const std::vector<RawPoints>& samples) {
  float most = 0;
  for (const auto& sample : samples)
    for (const float value : sample.intensity) most = std::max(most, value);
  report_.facts["intensity"] = layout_ ? layout_->intensity ? layout_->intensity->name : "none" : "reflectivity";
  if (most > 0 && most <= 1) {
    intensity_factor_ = 255;
    report_.facts["intensity"] += ", 0 to 1 in the messages, times 255";
  }
}

// What the tags of Livox points say was learnt from the manuals of Avia, Mid-70 and HAP. Of the Mid-360 no sheet was at
// hand, so what they do is told, and a number that no second return bears out is none.
void BagCloudSource::learn_tags(const std::vector<RawPoints>& samples) {
  constexpr double many = 0.2;
  std::size_t points = 0, noise = 0, numbered = 0, borne_out = 0;
  for (const auto& sample : samples) {
    points += sample.positions.size() + sample.tagged_noise;
    noise += sample.tagged_noise;
    if (!rosette_) continue;  // fields of other makers name their returns
    const auto [later, same_ray] = returns_on_one_ray(sample);
    numbered += later;
    borne_out += same_ray;
  }
  if (numbered > 0 && 2 * borne_out < numbered) {
    tags_number_returns_ = false;
    report_.facts["returns"] = "one: the numbers in the tags are not of returns on one ray";
  }
  if (noise == 0) return;
  const double share = static_cast<double>(noise) / static_cast<double>(points);
  report_.facts["noise_by_tag"] = number_text(std::round(1000 * share) / 10) + " % of the points are left out";
  if (share > many)
    report_.find(
        Severity::look, "tags_leave_out_many",
        number_text(std::round(100 * share)) +
            " % of the points are left out because their tag says that they are noise (rain, dust, or "
            "between two surfaces). In dry air that is too many: the device may give its tags another meaning");
}

// Recorders write a message some ms after its last point, all at about the same delay.
void BagCloudSource::learn_index_times(const std::vector<Sample>& samples) {
  constexpr double max_spread_s = 0.2;
  std::vector<double> shifts_s;
  ScanFrame frame;
  for (const auto& sample : samples) {
    if (sample.recorded_ns < 0) return;  // a time that no clock shows
    set_times(sample.points, frame);
    shifts_s.push_back(frame.start_time_s - seconds(sample.recorded_ns));
  }
  std::ranges::sort(shifts_s);
  if (shifts_s.back() - shifts_s.front() < max_spread_s) index_shift_s_ = shifts_s[shifts_s.size() / 2];
}

// Clouds in the axes of a map or a robot have lost the place of the sensor.
void BagCloudSource::check_axes(const std::vector<RawPoints>& samples) {
  constexpr std::array<std::string_view, 7> foreign{"map",       "odom",           "world", "camera_init",
                                                    "base_link", "base_footprint", "earth"};
  std::string_view frame = samples.front().frame_id;
  report_.facts["frame_id"] = std::string(frame);
  if (!frame.empty() && frame.front() == '/') frame.remove_prefix(1);
  if (std::ranges::find(foreign, frame) != foreign.end())
    report_.find(Severity::look, "axes_not_of_sensor",
                 "the points are in the axes '" + std::string(frame) +
                     "', which are not those of a scanner: ranges and rays are "
                     "wrong unless both have the same origin. Choose the topic that the driver of the scanner writes");
  std::size_t missing = 0;
  for (const auto& sample : samples) missing += sample.missing > 0 ? 1 : 0;
  if (missing > 0)
    report_.find(Severity::look, "input_damaged",
                 std::to_string(missing) + " of " + std::to_string(samples.size()) +
                     " messages that were looked at hold fewer points than they declare");
}

void BagCloudSource::set_times(const RawPoints& points, ScanFrame& frame) const {
  const double stamp_s = seconds(points.stamp_ns);
  frame.time_offset_s.resize(points.positions.size());
  if (times_.origin == TimeOrigin::none || points.time.size() != points.positions.size()) {
    frame.time_offset_s = times_from_azimuths(points.positions, period_s_);
    frame.start_time_s = stamp_s - period_s_ / 2;
  } else if (points.time.empty()) {
    frame.start_time_s = stamp_s;
  } else {
    const double first = *std::ranges::min_element(points.time);
    const bool from_stamp = times_.origin == TimeOrigin::after_stamp;
    const double origin = starts_at_stamp_ ? 0 : from_stamp ? std::min(first, 0.0) : first;
    frame.start_time_s = (from_stamp ? stamp_s : times_.shift_s) + origin * times_.unit_s;
    if (!from_stamp && std::abs(frame.start_time_s - stamp_s) > times_.jump_s) frame.start_time_s = stamp_s;
    for (std::size_t i = 0; i < points.time.size(); ++i)
      frame.time_offset_s[i] = static_cast<float>((points.time[i] - origin) * times_.unit_s);
  }
  frame.end_time_s = frame.start_time_s;
  if (!frame.time_offset_s.empty()) frame.end_time_s += std::ranges::max(frame.time_offset_s);
}

void BagCloudSource::set_rings(const RawPoints& points, ScanFrame& frame) const {
  const auto count = points.positions.size();
  if (rosette_) {
    frame.ring.assign(count, 0);
  } else if (!ring_order_.empty() && points.ring.size() == count) {
    frame.ring.resize(count);
    for (std::size_t i = 0; i < count; ++i) frame.ring[i] = ring_order_.ring(points.ring[i], points.positions[i]);
  } else {
    frame.ring.clear();
    if (rings_by_order_) frame.ring = rings_from_order(points.positions);
    if (frame.ring.empty()) frame.ring = rings_from_elevations(points.positions, elevations_rad_);
  }
}

void BagCloudSource::read(std::size_t index, ScanFrame& frame) const {
  if (index >= messages_.size())
    throw bad_input("frame " + std::to_string(index) + " of '" + path_.string() + "'",
                    "0 to " + std::to_string(messages_.size() - 1));
  auto& points = scratch_;
  try {
    decode(index, points);
  } catch (const Error& e) {
    throw e.at("frame " + std::to_string(index) + " (topic " + topic_.name + ")");
  }
  frame.clear();
  set_times(points, frame);
  set_rings(points, frame);
  const auto count = points.positions.size();
  frame.positions = points.positions;
  frame.intensity.assign(count, 0);
  if (points.intensity.size() == count)
    for (std::size_t i = 0; i < count; ++i) frame.intensity[i] = intensity_factor_ * points.intensity[i];
  frame.return_number.assign(count, 1);
  if (points.return_number.size() == count && tags_number_returns_)
    for (std::size_t i = 0; i < count; ++i)
      frame.return_number[i] = static_cast<std::uint8_t>(std::clamp<std::int64_t>(points.return_number[i], 1, 255));
  start_times_s_[index] = frame.start_time_s;
}

double BagCloudSource::frame_time_s(std::size_t index) const {
  double& start_s = start_times_s_.at(index);
  if (!std::isnan(start_s)) return start_s;
  try {
    start_s = start_time_s(index);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    start_s = seconds(messages_[index].time_ns);  // what is wrong is told when the frame is read
  }
  return start_s;
}

double BagCloudSource::index_time_s(std::size_t index) const {
  const auto recorded_ns = messages_.at(index).time_ns;
  if (!index_shift_s_ || recorded_ns < 0) return frame_time_s(index);
  return seconds(recorded_ns) + *index_shift_s_;
}

// Points are decoded only where the start follows from their times.
double BagCloudSource::start_time_s(std::size_t index) const {
  if (topic_.type == message_type::cloud && starts_at_stamp_)
    return seconds(parse_stamp_ns(bag_->read(messages_[index]), topic_.encoding));
  decode(index, scratch_);
  ScanFrame frame;
  set_times(scratch_, frame);
  return frame.start_time_s;
}

int BagCloudSource::rings() const { return rosette_ ? 1 : static_cast<int>(elevations_rad_.size()); }

std::string BagCloudSource::description() const {
  return path_.filename().string() + ": " + std::to_string(messages_.size()) +
         (messages_.size() == 1 ? " frame" : " frames") + " of " + topic_.name + ", " +
         (model_     ? model_->name
          : rosette_ ? "rosette"
                     : std::to_string(rings()) + " rings");
}

}  // namespace bole::io
