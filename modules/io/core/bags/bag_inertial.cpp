#include "io/core/bags/bag_inertial.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/option.h"
#include "io/core/bags/messages.h"

namespace bole::io {
namespace {

constexpr double standard_gravity = 9.80665;

// Groups of messages that follow each other, spread over the recording: each group costs a chunk or two.
std::vector<std::size_t> sampled(std::size_t messages) {
  constexpr std::size_t groups = 8, group_size = 25;
  std::vector<std::size_t> out;
  for (std::size_t g = 0; g < groups; ++g) {
    const auto first = g * messages / groups, last = std::min((g + 1) * messages / groups, first + group_size);
    for (std::size_t i = first; i < last; ++i) out.push_back(i);
  }
  if (messages > 0 && out.back() != messages - 1) out.push_back(messages - 1);
  return out;
}

}  // namespace

BagInertial::BagInertial(std::shared_ptr<const Bag> bag, std::size_t topic, const Run& run, Report& report)
    : bag_(std::move(bag)), topic_(bag_->topics()[topic]), messages_(bag_->index(topic, run)) {
  std::vector<InertialSample> seen;
  std::string trouble = "no message";
  std::size_t damaged = 0, repeated = 0;
  stamped_ = false;
  for (const auto i : sampled(messages_.size())) {
    try {
      const auto message = parse_imu(bag_->read(messages_[i]), topic_.encoding);
      if (!message.angular_rate.allFinite() || !message.acceleration.allFinite()) {
        ++damaged;
        trouble = "values that are no numbers";
        continue;
      }
      stamped_ = stamped_ || message.header.stamp_ns != 0;
      seen.push_back({1e-9 * static_cast<double>(message.header.stamp_ns), message.angular_rate, message.acceleration});
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      ++damaged;
      trouble = e.found();
    }
  }
  for (std::size_t i = 1; i < seen.size(); ++i) repeated += seen[i].time_s == seen[i - 1].time_s ? 1 : 0;
  if (seen.empty())
    throw bad_input("topic " + topic_.name + " holds no measurement that can be read (" + trouble + ")",
                    "sensor_msgs/Imu");
  const auto of_seen =
      " of " + std::to_string(seen.size() + damaged) + " messages of " + topic_.name + " that were looked at ";
  if (damaged > 0)
    report.find(Severity::look, "input_damaged",
                std::to_string(damaged) + of_seen + "cannot be used (" + trouble + "): such messages are gaps");
  if (repeated > 0 && stamped_)
    report.warn(std::to_string(repeated) + of_seen + "have the time of the one before: such messages are left out");
  first_s_ = seen.front().time_s;
  last_s_ = seen.back().time_s;
  if (!stamped_) {
    report.warn("the messages of " + topic_.name + " have no stamps: their recording times are taken");
    first_s_ = 1e-9 * static_cast<double>(messages_.front().time_ns);
    last_s_ = 1e-9 * static_cast<double>(messages_.back().time_ns);
  }
  std::vector<double> sizes;
  for (const auto& s : seen) sizes.push_back(s.specific_force_m_s2.norm());
  std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
  const double usual = sizes[sizes.size() / 2];
  // Gravity is most of what a carried unit feels.
  if (usual > 0.7 && usual < 1.4) {
    acceleration_unit_ = standard_gravity;
    report.warn("the accelerations of " + topic_.name +
                " are about 1: they are taken as multiples of gravity, as the Livox drivers write them");
  } else if (usual < 7 || usual > 14) {
    report.find(Severity::look, "imu_without_gravity",
                "the accelerations of " + topic_.name + " are about " + number_text(std::round(usual * 100) / 100) +
                    " m/s2, not 9.8: gravity is missing, or the unit is another one");
  }
  report.counts["imu_messages"] = static_cast<std::int64_t>(messages_.size());
  report.facts["imu"] = topic_.name;
}

InertialSample BagInertial::sample(const BagMessage& message) const {
  const auto m = parse_imu(bag_->read(message), topic_.encoding);
  return {1e-9 * static_cast<double>(stamped_ ? m.header.stamp_ns : message.time_ns), m.angular_rate,
          acceleration_unit_ * m.acceleration};
}

const InertialRecord* BagInertial::record() const {
  if (record_) return record_.get();
  auto record = std::make_unique<InertialRecord>();
  record->name = topic_.name;
  for (const auto& message : messages_) {
    try {
      const auto s = sample(message);
      if (s.angular_rate_rad_s.allFinite() && s.specific_force_m_s2.allFinite()) record->samples.push_back(s);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;  // a damaged message is a gap
    }
  }
  auto& samples = record->samples;
  std::ranges::stable_sort(samples, {}, &InertialSample::time_s);
  const auto same = [](const InertialSample& a, const InertialSample& b) { return a.time_s == b.time_s; };
  samples.erase(std::unique(samples.begin(), samples.end(), same), samples.end());
  record_ = std::move(record);
  return record_.get();
}

}  // namespace bole::io
