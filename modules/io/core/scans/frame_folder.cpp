#include "io/core/scans/frame_folder.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/clouds/pcd_reader.h"
#include "io/core/scans/frame_estimates.h"
#include "io/core/scans/sensor_facts.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

// Whether `a` comes before `b` when the numbers in them are read as numbers: frame9 before frame10, 0009 before 10.
bool in_number_order(std::string_view a, std::string_view b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto number_of = [&](std::string_view& text) {  // its digits without zeros in front; the text goes on behind
    const auto end = std::ranges::find_if_not(text, is_digit);
    std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
  };
  const auto whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const auto m = number_of(a), n = number_of(b);
      if (m != n) return m.size() != n.size() ? m.size() < n.size() : m < n;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.empty() && b.empty() ? whole_a < whole_b : a.empty();
}

bool is_frame(const fs::path& path) { return path.extension() == ".bin" || path.extension() == ".pcd"; }

// The values of a file beside the frame, or nothing where there is none. Its length must fit the number of points.
template <class T>
std::vector<T> companion(fs::path path, const char* extension, std::size_t points) {
  path.replace_extension(extension);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  const MappedFile file(path);
  if (file.bytes().size() != points * sizeof(T))
    throw bad_input("'" + path.filename().string() + "' has " + std::to_string(file.bytes().size()) + " bytes",
                    std::to_string(points * sizeof(T)) + ", " + std::to_string(sizeof(T)) + " per point of the frame");
  std::vector<T> values(points);
  std::memcpy(values.data(), file.bytes().data(), file.bytes().size());
  return values;
}

void load_bin(const fs::path& path, ScanFrame& frame) {
  const MappedFile file(path);
  const auto bytes = file.bytes();
  constexpr std::size_t point_bytes = 4 * sizeof(float);
  if (bytes.size() % point_bytes != 0)
    throw bad_input(std::to_string(bytes.size()) + " bytes, which is no whole number of points",
                    "16 bytes per point: x, y, z, intensity as float32");
  const std::size_t points = bytes.size() / point_bytes;
  frame.positions.resize(points);
  frame.intensity.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    std::memcpy(frame.positions[i].data(), bytes.data() + i * point_bytes, 3 * sizeof(float));
    std::memcpy(&frame.intensity[i], bytes.data() + i * point_bytes + 3 * sizeof(float), sizeof(float));
  }
  frame.time_offset_s = companion<float>(path, ".time", points);
  frame.ring = companion<std::uint16_t>(path, ".ring", points);
}

// Seconds per unit of times that cover one revolution: files have seconds, milli-, micro- or nanoseconds.
double seconds_per_unit(double span) {
  double unit = 1;
  while (span * unit > 2 && unit > 1e-9) unit *= 1e-3;
  return unit;
}

void load_pcd(const fs::path& path, ScanFrame& frame) {
  const MappedFile file(path);
  const auto cloud = read_pcd(file.bytes(), {}, {}).cloud;
  const Eigen::Vector3f shift = cloud.origin.cast<float>();
  for (const auto& p : cloud.positions()) frame.positions.push_back(p + shift);
  if (cloud.has(arrays::intensity)) frame.intensity = cloud.values<float>(arrays::intensity);
  if (cloud.has(arrays::ring)) frame.ring = cloud.values<std::uint16_t>(arrays::ring);
  if (!cloud.has(arrays::time) || cloud.empty()) return;
  const auto& times = cloud.values<double>(arrays::time);
  const auto [first, last] = std::ranges::minmax(times);
  const double unit = seconds_per_unit(last - first);
  for (const double t : times) frame.time_offset_s.push_back(static_cast<float>((t - first) * unit));
}

// Seconds as a number, or KITTI's "2011-09-26 13:02:25.964389445" (taken as UTC).
bool parse_time(const std::string& line, double& seconds) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, read = 0;
  const auto number = [&line](std::size_t at, double& value) {  // independent of the locale, unlike scanf
    return std::from_chars(line.data() + at, line.data() + line.size(), value).ec == std::errc{} &&
           std::isfinite(value);
  };
  std::sscanf(line.c_str(), "%d-%d-%d %d:%d:%n", &year, &month, &day, &hour, &minute, &read);
  if (double second = 0; read > 0 && number(static_cast<std::size_t>(read), second)) {
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) return false;
    seconds = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count()) * 86400.0 + hour * 3600.0 +
              minute * 60.0 + second;
    return true;
  }
  return number(0, seconds);
}

std::vector<double> read_times(const fs::path& path) {
  std::vector<double> times;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    line.erase(0, line.find_first_not_of(" \t+"));
    double seconds = 0;
    if (line.empty() || line[0] == '#') continue;
    if (!parse_time(line, seconds))
      throw bad_input(
          "'" + path.string() + "' line " + std::to_string(times.size() + 1) + " is '" + line.substr(0, 40) + "'",
          "a time in seconds, or a date and time");
    times.push_back(seconds);
  }
  return times;
}

}  // namespace

bool FrameFolderSource::holds_frames(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_frame(entry.path())) return true;
  return false;
}

std::optional<fs::path> FrameFolderSource::find_frames(const fs::path& folder) {
  if (holds_frames(folder)) return folder;
  // KITTI raw keeps its frames in velodyne_points/data, KITTI odometry in velodyne.
  for (const char* inner : {"data", "velodyne", "velodyne_points/data"})
    if (holds_frames(folder / inner)) return folder / inner;
  return {};
}

FrameFolderSource::FrameFolderSource(const fs::path& folder, const FrameSourceOptions& options, const Run& run)
    : folder_(folder), options_(options) {
  find_files();
  check_sizes();
  run.check_cancel();
  find_times();
  find_sensor();
  learn_rings();
  report_.counts["frames"] = static_cast<std::int64_t>(files_.size());
  report_.facts["sensor"] = model_ ? model_->name : "unknown, " + std::to_string(rings()) + " rings";
  report_.message = description();
}

void FrameFolderSource::find_files() {
  for (const auto& entry : fs::directory_iterator(folder_))
    if (is_frame(entry.path())) files_.push_back(entry.path());
  if (files_.empty())
    throw bad_input("the folder '" + folder_.string() + "' holds no frames",
                    "files .bin (KITTI) or .pcd, one per frame");
  std::ranges::sort(files_, in_number_order, [](const fs::path& path) { return path.stem().string(); });
  const auto extension = files_.front().extension();
  const auto others = std::erase_if(files_, [&](const fs::path& p) { return p.extension() != extension; });
  if (others > 0)
    report_.warn(std::to_string(others) + " files were skipped: frames are read from *" + extension.string() + " only");
}

// Frames are read one by one, when nobody may look at what was lost any more: their sizes tell before.
void FrameFolderSource::check_sizes() {
  constexpr std::uintmax_t point_bytes = 16;
  std::size_t damaged = 0;
  fs::path first;
  for (const auto& file : files_) {
    std::error_code error;
    const auto bytes = fs::file_size(file, error);
    const bool whole = !error && bytes > 0 && (file.extension() != ".bin" || bytes % point_bytes == 0);
    if (!whole && damaged++ == 0) first = file;
  }
  if (damaged == 0) return;
  report_.counts["damaged_frames"] = static_cast<std::int64_t>(damaged);
  report_.find(Severity::look, "input_damaged",
               std::to_string(damaged) + " of " + std::to_string(files_.size()) +
                   " frames are empty or cut off (first: " + first.filename().string() + ")");
}

void FrameFolderSource::find_times() {
  period_s_ = options_.frame_period;
  std::vector<double> times;
  for (const auto& place : {folder_ / "times.txt", folder_ / "timestamps.txt", folder_.parent_path() / "times.txt",
                            folder_.parent_path() / "timestamps.txt"}) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) continue;
    times = read_times(place);
    if (times.size() == files_.size() && std::ranges::adjacent_find(times, std::greater_equal<>()) == times.end())
      break;
    report_.warn("'" + place.filename().string() + "' is not used: it has " + std::to_string(times.size()) +
                 " times for " + std::to_string(files_.size()) + " frames, or they do not increase");
    times.clear();
  }
  std::error_code ignored;
  const bool own_times = fs::exists(fs::path(files_.front()).replace_extension(".time"), ignored);
  if (times.empty()) {
    for (std::size_t i = 0; i < files_.size(); ++i) start_times_s_.push_back(static_cast<double>(i) * period_s_);
    set_fact(facts_, Clock::assumed);
    report_.facts["clock"] = "frames at " + number_text(period_s_) + " s";
    return;
  }
  set_fact(facts_, Clock::file);
  report_.facts["clock"] = "times file";
  if (times.size() > 1) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
    period_s_ = steps[steps.size() / 2];
  }
  for (const double t : times) start_times_s_.push_back(own_times ? t : t - period_s_ / 2);
}

void FrameFolderSource::find_sensor() {
  std::string name = options_.sensor;
  if (std::ifstream file(folder_ / "sensor.json"); name == "auto" && file) {
    const auto json = nlohmann::json::parse(file, nullptr, false);
    const auto path = folder_ / "sensor.json";
    if (json.is_object() && (json.contains("elevation_deg") || json.contains("pattern"))) {
      model_ = sensor::sensor_model_from_json(json, json.value("name", "sensor"));
    } else {
      if (!json.is_object() || !json.contains("sensor") || !json["sensor"].is_string())
        throw bad_input("'" + path.string() + "' cannot be used",
                        R"({"sensor": "os1_64"}, or a description of the sensor as in resources/sensors)");
      name = json["sensor"].get<std::string>();
    }
  }
  if (name != "auto") model_ = sensor::load_sensor_model(name);
  if (model_) facts_.merge(sensor_facts(*model_));
}

// Frames spread over the walk, without the first. A frame below open sky shows only some of the rings.
std::vector<ScanFrame> FrameFolderSource::sample_frames() const {
  constexpr std::size_t max_frames = 8;
  const std::size_t count = std::min(max_frames, files_.size());
  std::vector<ScanFrame> sample;
  for (std::size_t k = 1; k < count; ++k) {
    ScanFrame frame;
    try {
      load(k * (files_.size() - 1) / (count - 1), frame);
    } catch (const Error&) {
      continue;  // reported when the frame is read
    }
    sample.push_back(std::move(frame));
  }
  return sample;
}

void FrameFolderSource::learn_own_rings(ScanFrame first) {
  for (const auto& frame : sample_frames()) {
    if (frame.ring.size() != frame.positions.size()) continue;
    first.positions.insert(first.positions.end(), frame.positions.begin(), frame.positions.end());
    first.ring.insert(first.ring.end(), frame.ring.begin(), frame.ring.end());
  }
  elevations_rad_ = mean_elevations_rad(first.positions, first.ring);
}

// Takes the frame that shows the most rings.
void FrameFolderSource::learn_rings_from_order(const ScanFrame& first) {
  elevations_rad_ = mean_elevations_rad(first.positions, rings_from_order(first.positions));
  for (const auto& frame : sample_frames())
    if (const auto rings = rings_from_order(frame.positions);
        !rings.empty() && std::ranges::max(rings) >= elevations_rad_.size())
      elevations_rad_ = mean_elevations_rad(frame.positions, rings);
}

void FrameFolderSource::learn_rings() {
  ScanFrame frame;
  try {
    load(0, frame);
  } catch (const Error& e) {
    throw e.at(files_.front().string());
  }
  if (files_.front().extension() == ".bin" && !frame.intensity.empty() && std::ranges::max(frame.intensity) <= 1) {
    intensity_factor_ = 255;
    report_.facts["intensity"] = "0 to 1 in the files, times 255";
  }
  if (model_) {
    elevations_rad_ = model_->ring_elevations_rad();
    return;
  }
  if (!frame.ring.empty()) {
    learn_own_rings(std::move(frame));
    return;
  }
  ring_order_ = !rings_from_order(frame.positions).empty();
  if (ring_order_)
    learn_rings_from_order(frame);
  else
    elevations_rad_ = even_elevations_rad(frame.positions, options_.rings);
  report_.facts["rings"] = ring_order_ ? "from the order of the points" : "from elevations";
  if (!ring_order_)
    report_.warn("the frames have no rings: " + std::to_string(options_.rings) +
                 " evenly spaced ones are assumed. Name the sensor with the option sensor");
}

void FrameFolderSource::load(std::size_t index, ScanFrame& frame) const {
  frame.clear();
  if (files_[index].extension() == ".bin")
    load_bin(files_[index], frame);
  else
    load_pcd(files_[index], frame);
  const std::size_t points = frame.positions.size();
  frame.intensity.resize(points, 0);
  frame.return_number.assign(points, 1);
  keep_valid(frame);
}

// Drops points that are not numbers, lie at the sensor (KITTI pads with zeros) or outside the limits of range.
void FrameFolderSource::keep_valid(ScanFrame& frame) const {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const float range = frame.positions[i].norm();
    if (!(range >= static_cast<float>(options_.min_range) && range <= static_cast<float>(options_.max_range)) ||
        range == 0)
      continue;
    frame.positions[kept] = frame.positions[i];
    frame.intensity[kept] = intensity_factor_ * frame.intensity[i];
    if (!frame.time_offset_s.empty()) frame.time_offset_s[kept] = frame.time_offset_s[i];
    if (!frame.ring.empty()) frame.ring[kept] = frame.ring[i];
    ++kept;
  }
  frame.positions.resize(kept);
  frame.intensity.resize(kept);
  frame.return_number.resize(kept);
  if (!frame.time_offset_s.empty()) frame.time_offset_s.resize(kept);
  if (!frame.ring.empty()) frame.ring.resize(kept);
}

void FrameFolderSource::read(std::size_t index, ScanFrame& frame) const {
  if (index >= files_.size())
    throw bad_input("frame " + std::to_string(index) + " of '" + folder_.string() + "'",
                    "0 to " + std::to_string(files_.size() - 1));
  try {
    load(index, frame);
  } catch (const Error& e) {
    throw e.at("frame " + std::to_string(index) + " (" + files_[index].string() + ")");
  }
  frame.start_time_s = start_times_s_[index];
  if (frame.time_offset_s.empty()) frame.time_offset_s = times_from_azimuths(frame.positions, period_s_);
  if (frame.ring.empty() && ring_order_) frame.ring = rings_from_order(frame.positions);
  if (pattern() == ScanPattern::rosette) frame.ring.assign(frame.positions.size(), 0);
  if (frame.ring.empty()) frame.ring = rings_from_elevations(frame.positions, elevations_rad_);
  frame.end_time_s = frame.start_time_s + (frame.time_offset_s.empty() ? 0 : std::ranges::max(frame.time_offset_s));
}

std::string FrameFolderSource::description() const {
  return folder_.filename().string() + ": " + std::to_string(files_.size()) +
         (files_.size() == 1 ? " frame, " : " frames, ") + (model_ ? model_->name : std::to_string(rings()) + " rings");
}

}  // namespace bole::io
