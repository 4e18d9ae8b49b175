#include "io/core/scans/livox_lvx.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/angles.h"
#include "base/error.h"
#include "base/verdict.h"
#include "io/core/scans/beside_capture.h"
#include "io/core/scans/sensor_facts.h"
#include "sensor/core/livox_packet.h"

namespace bole::io {
namespace {

constexpr std::string_view signature = "livox_tech";
constexpr std::size_t public_header = 24, private_header = 5, block_header = 24;
constexpr double frame_s = 0.1;
constexpr std::size_t max_block_steps = 1'000'000'000;

// Device types of the maker. The place of the inertial unit in the axes of the points, from the user manuals.
struct DeviceKind {
  int type;
  bool lvx2;
  const char* name;
  const char* sensor;  // in resources/sensors, or null
  double points_per_s;
  std::array<double, 3> imu_m;
  bool has_imu;
};
constexpr std::array kinds{DeviceKind{1, false, "Livox Mid-40", nullptr, 100e3, {}, false},
                           DeviceKind{2, false, "Livox Tele-15", nullptr, 240e3, {}, false},
                           DeviceKind{3, false, "Livox Horizon", "horizon", 240e3, {-0.05512, -0.02226, 0.0297}, true},
                           DeviceKind{6, false, "Livox Mid-70", nullptr, 100e3, {}, false},
                           DeviceKind{7, false, "Livox Avia", "avia", 240e3, {-0.04165, -0.02326, 0.0284}, true},
                           DeviceKind{9, true, "Livox Mid-360", "mid360", 200e3, {0.011, 0.02329, -0.04412}, true}};

const DeviceKind* kind_of(int type, bool lvx2) {
  const auto it = std::ranges::find_if(kinds, [&](const DeviceKind& k) { return k.type == type && k.lvx2 == lvx2; });
  return it == kinds.end() ? nullptr : &*it;
}

std::uint64_t get(Bytes p, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value |= static_cast<std::uint64_t>(p[at + i]) << (8 * i);
  return value;
}

double get_float(Bytes p, std::size_t at) { return std::bit_cast<float>(static_cast<std::uint32_t>(get(p, at, 4))); }

// Type 3: year after 2000, month, day, hour, then microseconds of the hour. All others: nanoseconds.
double time_of(Bytes p, std::size_t at, std::uint8_t type) {
  constexpr std::uint8_t gps = 3;
  if (type != gps) return 1e-9 * static_cast<double>(get(p, at, 8));
  const std::chrono::year_month_day date{std::chrono::year(2000 + p[at]), std::chrono::month(p[at + 1]),
                                         std::chrono::day(p[at + 2])};
  if (!date.ok()) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count()) * 86400.0 + p[at + 3] * 3600.0 +
         1e-6 * static_cast<double>(get(p, at + 4, 4));
}

Pose extrinsics(Bytes p, std::size_t at) {  // roll, pitch, yaw in degrees; x, y, z in metres
  Pose T = Pose::Identity();
  std::array<double, 6> v{};
  for (std::size_t i = 0; i < 6; ++i) v[i] = get_float(p, at + 4 * i);
  if (!std::ranges::all_of(v, [](double x) { return std::isfinite(x) && std::abs(x) < 1e4; }))
    throw bad_input("the extrinsics of a device are no numbers", "angles in degrees, and metres");
  T.linear() = rotation_from_rpy(v[0] * rad_per_deg, v[1] * rad_per_deg, v[2] * rad_per_deg);
  T.translation() = Eigen::Vector3d(v[3], v[4], v[5]);
  return T;
}

}  // namespace

struct LvxSource::Counts {
  std::int64_t packages = 0, inertial = 0, unknown = 0, out_of_order = 0, blocks = 0;
  std::size_t damaged_at = 0;
  bool damaged = false, utc = false, open = false;
};

bool looks_like_lvx(Bytes file) {
  return std::string_view(reinterpret_cast<const char*>(file.data()), file.size()).starts_with(signature);
}

LvxSource::LvxSource(const std::filesystem::path& path, const FrameSourceOptions& options, const Run& run)
    : path_(path), name_(path.filename().string()), options_(options), file_(path), bytes_(file_->bytes()) {
  open(run);
}

LvxSource::LvxSource(Bytes file, std::string name, const FrameSourceOptions& options, const Run& run)
    : path_(name), name_(std::move(name)), options_(options), bytes_(file) {
  open(run);
}

// The headers, up to the first block.
std::size_t LvxSource::read_header() {
  if (!looks_like_lvx(bytes_) || bytes_.size() < public_header + private_header)
    throw bad_input("'" + name_ + "' has " + std::to_string(bytes_.size()) + " bytes and no header of an LVX file",
                    "an LVX or LVX2 file");
  const int version = bytes_[16], minor = bytes_[17];
  lvx2_ = version == 2;
  if (!lvx2_ && !(version == 1 && minor >= 1))
    throw bad_input(
        "'" + name_ + "' is an LVX file of version " + std::to_string(version) + "." + std::to_string(minor),
        "version 1.1 or 2", "Convert it with Livox Viewer");
  const auto duration_ms = get(bytes_, public_header, 4);
  if (duration_ms >= 1 && duration_ms <= 1000) block_s_ = 1e-3 * static_cast<double>(duration_ms);
  const std::size_t count = bytes_[public_header + 4], device_bytes = lvx2_ ? 63 : 59;
  const std::size_t end = public_header + private_header + count * device_bytes;
  if (count == 0 || end > bytes_.size())
    throw bad_input("'" + name_ + "' declares " + plural(static_cast<std::int64_t>(count), "device") + " in " +
                        std::to_string(bytes_.size()) + " bytes",
                    "the description of at least one device");
  for (std::size_t d = 0; d < count; ++d) {
    const std::size_t at = public_header + private_header + d * device_bytes + 32;
    Device device;
    device.id = static_cast<std::uint32_t>(lvx2_ ? get(bytes_, at, 4) : bytes_[at]);
    const std::size_t type_at = lvx2_ ? at + 5 : at + 1;
    device.type = bytes_[type_at];
    device.placed = bytes_[type_at + 1] != 0;
    if (device.placed) device.T_rig_device = extrinsics(bytes_, type_at + 2);
    devices_.push_back(device);
  }
  return end;
}

std::optional<LvxSource::Package> LvxSource::package_at(std::size_t at, std::size_t end) const {
  const std::size_t header = lvx2_ ? 27 : 19;
  if (at + header > end) return {};
  Package p;
  if (lvx2_) {
    p.device = static_cast<std::uint32_t>(get(bytes_, at + 1, 4));
    p.time_type = bytes_[at + 6];
    p.time_s = time_of(bytes_, at + 7, p.time_type);
    p.data_type = bytes_[at + 17];
    p.bytes = get(bytes_, at + 18, 4);
  } else {
    p.device = bytes_[at];
    p.time_type = bytes_[at + 9];
    p.data_type = bytes_[at + 10];
    p.time_s = time_of(bytes_, at + 11, p.time_type);
    const auto layout = sensor::livox_layout(p.data_type, false);
    if (!layout) return {};  // its length is not known, and nothing behind it can be found
    p.bytes = layout->firings * layout->firing_bytes;
  }
  p.data = at + header;
  if (p.bytes > end - p.data) return {};
  p.next = p.data + p.bytes;
  return p;
}

void LvxSource::index_block(std::size_t begin, std::size_t end, Counts& counts) {
  std::size_t at = begin;
  while (at < end) {
    const auto package = package_at(at, end);
    if (!package) {
      counts.damaged = true;
      counts.damaged_at = at;
      break;
    }
    at = package->next;
    ++counts.packages;
    const auto layout = sensor::livox_layout(package->data_type, lvx2_);
    if (!layout || !std::isfinite(package->time_s)) {
      ++counts.unknown;
      continue;
    }
    if (package->time_type == 1 || package->time_type == 3) counts.utc = true;
    if (layout->coordinates == sensor::LivoxLayout::Coordinates::inertial) {
      auto sample = sensor::decode_livox_inertial(bytes_.subspan(package->data, package->bytes));
      if (!sample || package->device != devices_.front().id) continue;
      sample->time_s = package->time_s;
      inertial_.samples.push_back(*sample);
      ++counts.inertial;
      continue;
    }
    auto& frame = frames_.back();
    if (!counts.open) {
      frame.start_time_s = frame.end_time_s = package->time_s;
      counts.open = true;
    }
    if (package->time_s < frame.end_time_s) ++counts.out_of_order;
    frame.start_time_s = std::min(frame.start_time_s, package->time_s);
    frame.end_time_s = std::max(frame.end_time_s, package->time_s);
  }
  frames_.back().end = std::min(at, end);
  ++frames_.back().blocks;
}

// A frame without a package of points is none.
void LvxSource::close_frame(Counts& counts) {
  if (!frames_.empty() && !counts.open) frames_.pop_back();
  counts.open = false;
}

void LvxSource::open(const Run& run) {
  std::size_t at = read_header();
  const int blocks_per_frame = std::max(1, static_cast<int>(std::lround(frame_s / block_s_)));
  Counts counts;
  for (std::size_t step = 0; step < max_block_steps && at + block_header <= bytes_.size() && !counts.damaged; ++step) {
    if (step % 64 == 0) {
      run.check_cancel();
      run.report(static_cast<double>(at) / static_cast<double>(bytes_.size()), "indexing blocks");
    }
    const auto current = get(bytes_, at, 8), next = get(bytes_, at + 8, 8);
    std::size_t end = bytes_.size();
    if (current != at) {
      counts.damaged = true;
      counts.damaged_at = at;
      break;
    }
    if (next > at && next <= bytes_.size())
      end = next;
    else if (next > bytes_.size()) {
      counts.damaged = true;
      counts.damaged_at = at;
    }
    if (frames_.empty() || !counts.open || frames_.back().blocks >= blocks_per_frame) {
      close_frame(counts);
      frames_.push_back({at, at, 0, 0, 0});
    }
    index_block(at + block_header, end, counts);
    ++counts.blocks;
    at = end;
  }
  close_frame(counts);
  if (!options_.keep_partial_frames && frames_.size() > 1 && frames_.back().blocks < blocks_per_frame)
    frames_.pop_back();
  if (frames_.empty())
    throw bad_input("'" + name_ + "' has no points (" + plural(counts.blocks, "block") + ", " +
                        plural(counts.packages, "package") + ")",
                    "an LVX or LVX2 file with points");
  fill_report(counts);
}

void LvxSource::fill_report(Counts& counts) {
  auto& samples = inertial_.samples;
  std::ranges::stable_sort(samples, {}, &InertialSample::time_s);
  const auto last =
      std::unique(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return !(a.time_s < b.time_s); });
  samples.erase(last, samples.end());
  const auto& first = devices_.front();
  if (const auto* kind = kind_of(first.type, lvx2_)) {
    sensor_name_ = kind->name;
    if (kind->sensor != nullptr) {
      sensor_ = kind->sensor;
      facts_ = sensor_facts(sensor::load_sensor_model(kind->sensor));
    } else {
      set_fact(facts_, facts::sensor, kind->name);
    }
    if (kind->has_imu) {
      Pose T = Pose::Identity();
      T.translation() = Eigen::Vector3d(kind->imu_m[0], kind->imu_m[1], kind->imu_m[2]);
      inertial_.T_sensor_imu = devices_.size() > 1 ? first.T_rig_device * T : T;
    }
  } else {
    report_.warn("the device type " + std::to_string(first.type) + " is not known: its range noise and beam are not");
  }
  inertial_.name = sensor_name_;
  set_fact(facts_, counts.utc ? Clock::utc : Clock::recorder);
  report_.facts["sensor"] = sensor_name_;
  report_.facts["clock"] = counts.utc ? "sensor (UTC)" : "sensor, since it was switched on";
  auto& numbers = report_.counts;
  numbers["frames"] = static_cast<std::int64_t>(frames_.size());
  numbers["devices"] = static_cast<std::int64_t>(devices_.size());
  numbers["data_packets"] = counts.packages;
  numbers["inertial_packets"] = counts.inertial;
  numbers["other_packets"] = counts.unknown;
  numbers["packets_out_of_order"] = counts.out_of_order;
  if (counts.damaged) {
    const double share = static_cast<double>(counts.damaged_at) / static_cast<double>(bytes_.size());
    report_.find(share >= 0.99 ? Severity::look : Severity::refused,
                 share >= 0.99 ? "input_damaged" : std::string(finding_code::input_incomplete),
                 "the file is cut off or damaged after " + plural(counts.packages, "package") + " (" +
                     std::to_string(static_cast<int>(100 * share)) +
                     " % of the file): the frames before that are read");
  }
  if (counts.unknown > 0) report_.warn(plural(counts.unknown, "package") + " of a type that is not known were skipped");
  if (devices_.size() == 1 && first.placed)
    report_.facts["extrinsics"] = "not applied: the points are in the axes of the device";
  if (devices_.size() > 1 && std::ranges::any_of(devices_, [](const Device& d) { return !d.placed; }))
    report_.warn("the file has " + std::to_string(devices_.size()) +
                 " devices, and not all of them have extrinsics: calibrate them in Livox Viewer");
  report_.message = description();
}

std::string LvxSource::description() const {
  return name_ + ": " + plural(static_cast<std::int64_t>(frames_.size()), "frame") + ", " + sensor_name_ +
         (devices_.size() > 1 ? " and " + plural(static_cast<std::int64_t>(devices_.size()) - 1, "other device") : "");
}

const LvxSource::Device* LvxSource::device_of(std::uint32_t id) const {
  const auto it = std::ranges::find(devices_, id, &Device::id);
  return it == devices_.end() ? nullptr : &*it;
}

// The stamp of a package is that of its first point; the others follow at the rate of the device.
double LvxSource::firing_period_s(const Package& package) const {
  constexpr double usual_points_per_s = 200e3;
  const auto* device = device_of(package.device);
  const auto* kind = device == nullptr ? nullptr : kind_of(device->type, lvx2_);
  return 1 / (kind == nullptr ? usual_points_per_s : kind->points_per_s);
}

void LvxSource::read(std::size_t index, ScanFrame& frame) const {
  if (index >= frames_.size())
    throw bad_input("frame " + std::to_string(index) + " of '" + name_ + "'",
                    "0 to " + std::to_string(frames_.size() - 1));
  const auto& entry = frames_[index];
  frame.clear();
  frame.start_time_s = entry.start_time_s;
  std::vector<sensor::LivoxPoint> points;
  double last_s = 0;
  for (std::size_t at = entry.begin; at + block_header <= entry.end;) {
    const auto next = get(bytes_, at + 8, 8);
    const std::size_t end = next > at && next <= entry.end ? next : entry.end;
    std::size_t place = at + block_header;
    while (const auto package = package_at(place, end)) {
      place = package->next;
      const auto layout = sensor::livox_layout(package->data_type, lvx2_);
      const auto* device = device_of(package->device);
      if (!layout || !std::isfinite(package->time_s)) continue;
      points.clear();
      sensor::decode_livox_points(*layout, bytes_.subspan(package->data, package->bytes), points);
      const double period_s = firing_period_s(*package);
      for (const auto& p : points) {
        const float range_m = p.position.norm();
        if (range_m < options_.min_range || range_m > options_.max_range) continue;
        const double offset_s = package->time_s - entry.start_time_s + period_s * p.index;
        last_s = std::max(last_s, offset_s);
        frame.positions.push_back(devices_.size() > 1 && device != nullptr
                                      ? (device->T_rig_device * p.position.cast<double>()).cast<float>().eval()
                                      : p.position);
        frame.time_offset_s.push_back(static_cast<float>(offset_s));
        frame.ring.push_back(0);
        frame.intensity.push_back(p.reflectivity);
        frame.return_number.push_back(p.return_number);
      }
    }
    at = end;
  }
  frame.end_time_s = frame.start_time_s + last_s;
}

}  // namespace bole::io
