// The YAML of velodyne_pointcloud: a list of flat maps with numbers, in block or flow style, and two numbers beside it.
// No other YAML is understood.
#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "sensor/core/calibrated_lasers.h"
#include "sensor/core/velodyne_calibration.h"

namespace bole::sensor {
namespace {

constexpr std::size_t max_yaml_lasers = 1024;

using YamlEntry = std::map<std::string, std::string, std::less<>>;

struct YamlContent {
  YamlEntry top;
  std::vector<YamlEntry> lasers;
};

std::string_view without_blanks(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Goes through the text from key to key. An entry begins at a dash or a brace.
class YamlReader {
 public:
  explicit YamlReader(std::string_view text) : text_(text) {}

  YamlContent read() {
    while (at_ < text_.size()) step();
    finish_entry();
    return std::move(content_);
  }

 private:
  void step() {
    const char c = text_[at_];
    const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\n';
    if (c == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (c == '{' || c == '}' || (c == '-' && !is_word(next) && next != '-' && next != '.')) {
      finish_entry();
      ++at_;
    } else if (is_word(c)) {
      read_pair();
    } else {
      ++at_;
    }
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }

  void read_pair() {
    const auto begin = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    const auto key = text_.substr(begin, at_ - begin);
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != ':') return;  // no key
    ++at_;
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] == '[' || text_[at_] == '{') return;  // the list itself
    const auto end = std::min(text_.find_first_of(",}\n#", at_), text_.size());
    const auto value = without_blanks(text_.substr(at_, end - at_));
    at_ = end;
    if (value.empty()) return;  // the list follows
    const bool top = key == "num_lasers" || key == "distance_resolution";
    if (!(top ? content_.top : entry_).emplace(key, value).second)
      throw bad_input("'" + std::string(key) + "' is there twice in one entry",
                      "a list of lasers as velodyne_pointcloud has it");
  }

  void finish_entry() {
    if (entry_.empty()) return;
    if (content_.lasers.size() == max_yaml_lasers) throw bad_input("more than 1024 lasers", "up to 128");
    content_.lasers.push_back(std::exchange(entry_, {}));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  YamlEntry entry_;
  YamlContent content_;
};

std::optional<double> entry_number(const YamlEntry& entry, std::string_view key, double limit) {
  const auto it = entry.find(key);
  if (it == entry.end()) return {};
  return calibration_number(it->second, "'" + std::string(key) + "'", limit);
}

double entry_required(const YamlEntry& entry, std::string_view key, double limit) {
  if (const auto value = entry_number(entry, key, limit)) return *value;
  throw bad_input("a laser has no '" + std::string(key) + "'",
                  "laser_id, rot_correction and vert_correction of each laser");
}

// Angles are in radians, lengths in metres. The correction of a rotation grows counterclockwise.
CalibratedLaser laser_of(const YamlEntry& entry) {
  constexpr double max_offset_m = 1, max_range_offset_m = 10;
  const auto or_zero = [&](std::string_view key, double limit) { return entry_number(entry, key, limit).value_or(0); };
  CalibratedLaser laser;
  laser.id = entry_required(entry, "laser_id", 1023);
  laser.elevation_rad = entry_required(entry, "vert_correction", std::numbers::pi / 2);
  laser.azimuth_offset_rad = -entry_required(entry, "rot_correction", 2 * std::numbers::pi);
  auto& offsets = laser.offsets;
  offsets.range = or_zero("dist_correction", max_range_offset_m);
  offsets.vertical = or_zero("vert_offset_correction", max_offset_m);
  offsets.horizontal = or_zero("horiz_offset_correction", max_offset_m);
  const auto two_points = entry.find("two_pt_correction_available");
  offsets.two_points = two_points != entry.end() && (two_points->second == "true" || two_points->second == "True");
  if (!offsets.two_points) return laser;
  offsets.near_x = entry_required(entry, "dist_correction_x", max_range_offset_m);
  offsets.near_y = entry_required(entry, "dist_correction_y", max_range_offset_m);
  return laser;
}

}  // namespace

SensorModel velodyne_model_from_yaml(std::string_view yaml) {
  const auto content = YamlReader(yaml).read();
  if (content.lasers.empty())
    throw bad_input("the calibration lists no lasers", "the YAML of velodyne_pointcloud, or the db.xml of the maker");
  std::vector<CalibratedLaser> unit;
  for (const auto& entry : content.lasers) unit.push_back(laser_of(entry));
  constexpr double max_range_quantum_m = 0.1;
  const double count = entry_number(content.top, "num_lasers", 1024).value_or(static_cast<double>(unit.size()));
  if (count < static_cast<double>(unit.size()))
    throw bad_input(
        "num_lasers is " + std::to_string(static_cast<int>(count)) + ", the list has " + std::to_string(unit.size()),
        "as many as the list has");
  const double quantum_m = entry_number(content.top, "distance_resolution", max_range_quantum_m).value_or(0);
  if (quantum_m < 0) throw bad_input("'distance_resolution' is negative", "metres, such as 0.002");
  return calibrated_model(static_cast<std::size_t>(count), quantum_m, unit);
}

}  // namespace bole::sensor
