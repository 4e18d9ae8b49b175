#include "sensor/core/sensor_model.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "base/resources.h"
#include "sensor/core/velodyne_calibration.h"

namespace bole::sensor {
namespace {

constexpr std::size_t max_channels = 256;

double json_number(const nlohmann::json& json, const char* key, double min, double max) {
  const auto it = json.find(key);
  if (it == json.end())
    throw bad_input("'" + std::string(key) + "' is absent",
                    "a number from " + number_text(min) + " to " + number_text(max));
  if (!it->is_number() || !(it->get<double>() >= min && it->get<double>() <= max))
    throw bad_input("'" + std::string(key) + "' is " + it->dump(),
                    "a number from " + number_text(min) + " to " + number_text(max));
  return it->get<double>();
}

std::string json_text(const nlohmann::json& json, const char* key, const std::string& otherwise) {
  const auto it = json.find(key);
  if (it == json.end()) return otherwise;
  if (!it->is_string()) throw bad_input("'" + std::string(key) + "' is " + it->dump(), "a text");
  return it->get<std::string>();
}

std::vector<double> json_numbers(const nlohmann::json& json, const char* key, std::size_t count, double min,
                                 double max) {
  const auto it = json.find(key);
  if (it == json.end() || !it->is_array())
    throw bad_input("'" + std::string(key) + "' is not a list", "one number per laser, in the order of the packet");
  if (count == 0 ? it->empty() || it->size() > max_channels : it->size() != count)
    throw bad_input(
        "'" + std::string(key) + "' has " + std::to_string(it->size()) + " entries",
        count == 0 ? "1 to " + std::to_string(max_channels) : std::to_string(count) + ", as elevation_deg has");
  std::vector<double> values;
  for (const auto& v : *it) {
    if (!v.is_number() || !(v.get<double>() >= min && v.get<double>() <= max))
      throw bad_input("'" + std::string(key) + "' holds " + v.dump(),
                      "numbers from " + number_text(min) + " to " + number_text(max));
    values.push_back(v.get<double>());
  }
  return values;
}

std::vector<LaserChannel> channels_from(const nlohmann::json& json, double sequence_period_us) {
  const auto elevations = json_numbers(json, "elevation_deg", 0, -90, 90);
  const auto offsets = json_numbers(json, "azimuth_offset_deg", elevations.size(), -180, 180);
  const auto times = json_numbers(json, "firing_time_us", elevations.size(), 0, sequence_period_us);
  const bool heights_known = json.contains("height_offset_mm");
  const auto heights = heights_known ? json_numbers(json, "height_offset_mm", elevations.size(), -1000, 1000)
                                     : std::vector<double>(elevations.size());
  std::vector<std::size_t> by_elevation(elevations.size());
  std::iota(by_elevation.begin(), by_elevation.end(), std::size_t{0});
  std::ranges::stable_sort(by_elevation, {}, [&](std::size_t i) { return elevations[i]; });
  std::vector<LaserChannel> channels(elevations.size());
  for (std::size_t ring = 0; ring < by_elevation.size(); ++ring) {
    const std::size_t i = by_elevation[ring];
    channels[i] = {elevations[i] * rad_per_deg, offsets[i] * rad_per_deg, times[i] * 1e-6, static_cast<int>(ring)};
    channels[i].offsets.height = heights[i] * 1e-3;
  }
  return channels;
}

Rosette rosette_from(const nlohmann::json& json) {
  Rosette out;
  out.points_per_s = json_number(json, "points_per_s", 1, 1e8);
  out.beams = static_cast<int>(json_number(json, "beams", 1, 1000));
  out.horizontal_fov_rad = json_number(json, "horizontal_fov_deg", 0.1, 360) * rad_per_deg;
  const double min_deg = json_number(json, "min_elevation_deg", -90, 90);
  out.min_elevation_rad = min_deg * rad_per_deg;
  out.max_elevation_rad = json_number(json, "max_elevation_deg", min_deg, 90) * rad_per_deg;
  return out;
}

void read_pattern(const nlohmann::json& json, SensorModel& model) {
  const auto pattern = json_text(json, "pattern", "lines");
  if (pattern != "lines" && pattern != "rosette") throw bad_input("'pattern' is '" + pattern + "'", "lines or rosette");
  if (pattern == "rosette") {
    model.rosette = rosette_from(json);
    model.sequence_period_s = model.rosette->beams / model.rosette->points_per_s;
    return;
  }
  const double period_us = json_number(json, "sequence_period_us", 1, 1e6);
  model.sequence_period_s = period_us * 1e-6;
  model.channels = channels_from(json, period_us);
}

bool flag(const nlohmann::json& json, const char* key) {
  const auto it = json.find(key);
  if (it == json.end()) return false;
  if (!it->is_boolean()) throw bad_input("'" + std::string(key) + "' is " + it->dump(), "true or false");
  return it->get<bool>();
}

void read_packet_format(const nlohmann::json& json, SensorModel& model) {
  const auto format = json_text(json, "packet", "none");
  if (format == "none") return;
  if (format == "hesai" || format == "ouster") {
    model.packet = format == "hesai" ? PacketFormat::hesai : PacketFormat::ouster;
    return;
  }
  if (format != "velodyne") throw bad_input("'packet' is '" + format + "'", "velodyne, hesai, ouster or none");
  model.packet = PacketFormat::velodyne;
  model.sequences_per_block = static_cast<int>(json_number(json, "sequences_per_block", 1, 2));
  if (json.contains("product_id"))
    model.product_id = static_cast<std::uint8_t>(json_number(json, "product_id", 0, 255));
  const auto lasers = model.channels.size();
  if (!(lasers == 16 && model.sequences_per_block == 2) &&
      !((lasers == 32 || lasers == 64 || lasers == 128) && model.sequences_per_block == 1))
    throw bad_input("a Velodyne block of " + std::to_string(lasers) + " lasers and " +
                        std::to_string(model.sequences_per_block) + " sequences",
                    "16 lasers twice, 32 once, or 64 or 128 in banks of 32");
}

// "VLP-32C" and "vlp_32c" name the file vlp32c.json, "OS1-64" os1_64.json.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// The name that is meant, or the end. A maker may stand in front ("Livox Mid-360" is mid360), and the family may be
// left out ("XT-32" is pandar_xt32) where the rest is a name of one sensor only.
std::vector<std::string>::const_iterator find_name(const std::vector<std::string>& names, std::string_view wanted) {
  const auto name = plain(wanted);
  const auto exact = std::ranges::find(names, name, plain);
  if (exact != names.end() || name.size() < 4) return exact;
  const auto fits = [&](const std::string& n) { return name.ends_with(plain(n)) || plain(n).ends_with(name); };
  const auto first = std::ranges::find_if(names, fits);
  return std::ranges::count_if(names, fits) == 1 ? first : names.end();
}

}  // namespace

std::vector<double> SensorModel::ring_elevations_rad() const {
  std::vector<double> elevations(channels.size());
  for (const auto& c : channels) elevations[static_cast<std::size_t>(c.ring)] = c.elevation_rad;
  return elevations;
}

SensorModel sensor_model_from_json(const nlohmann::json& json, std::string id) {
  if (!json.is_object())
    throw bad_input("the sensor is not a JSON object", "an object with the entries of resources/sensors/vlp16.json");
  SensorModel model;
  model.name = json_text(json, "name", id);
  model.id = std::move(id);
  model.maker = json_text(json, "maker", "");
  model.source = json_text(json, "source", "");
  read_pattern(json, model);
  model.rotation_hz = json_number(json, "rotation_hz", 0.1, 100);
  model.range_quantum_m = json_number(json, "range_quantum_m", 1e-4, 1);
  model.min_range_m = json_number(json, "min_range_m", 0, 100);
  model.max_range_m = json_number(json, "max_range_m", model.min_range_m, 10000);
  model.range_sigma_m = json_number(json, "range_sigma_m", 0, 10);
  model.beam_divergence_horizontal_rad = json_number(json, "beam_divergence_horizontal_mrad", 0, 100) * 1e-3;
  model.beam_divergence_vertical_rad = json_number(json, "beam_divergence_vertical_mrad", 0, 100) * 1e-3;
  model.aperture_horizontal_m = json_number(json, "aperture_horizontal_mm", 0, 1000) * 1e-3;
  model.aperture_vertical_m = json_number(json, "aperture_vertical_mm", 0, 1000) * 1e-3;
  model.beam_assumed = flag(json, "beam_assumed");
  model.dual_return = flag(json, "dual_return");
  read_packet_format(json, model);
  return model;
}

SensorModel without_laser_heights(SensorModel model) {
  for (auto& c : model.channels) c.offsets.height = 0;
  return model;
}

bool has_laser_heights(const SensorModel& model) {
  return std::ranges::any_of(model.channels, [](const LaserChannel& c) { return c.offsets.height != 0; });
}

std::vector<std::string> sensor_model_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(resource_path("sensors")))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

namespace {

SensorModel load_velodyne_calibration(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw bad_input("cannot open '" + path.string() + "'", "the calibration of a Velodyne unit (XML or YAML)");
  std::string text(static_cast<std::size_t>(max_velodyne_calibration_bytes) + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_velodyne_calibration_bytes)
    throw bad_input("'" + path.string() + "' is larger than 4 MB", "the calibration of a Velodyne unit");
  try {
    auto model = velodyne_model_from(text);
    model.file = path;
    return model;
  } catch (const Error& e) {
    throw e.at(path.string());
  }
}

}  // namespace

SensorModel load_sensor_model(std::string_view name_or_path) {
  std::filesystem::path path(name_or_path);
  if (may_be_velodyne_calibration(path)) return load_velodyne_calibration(path);
  std::string id = path.stem().string();
  const bool named_file = path.extension() == ".json";
  if (!named_file) {
    const auto names = sensor_model_names();
    const auto it = find_name(names, name_or_path);
    if (it == names.end()) {
      std::string list;
      for (const auto& n : names) list += (list.empty() ? "" : ", ") + n;
      throw bad_input("there is no sensor '" + std::string(name_or_path) + "'",
                      "one of " + list + ", or the path of a JSON file or of a Velodyne calibration (XML, YAML)");
    }
    id = *it;
    path = resource_path("sensors/" + id + ".json");
  }
  std::ifstream file(path);
  if (!file) throw bad_input("cannot open '" + path.string() + "'", "a sensor description in JSON");
  const auto json = nlohmann::json::parse(file, nullptr, false, true);
  if (json.is_discarded())
    throw bad_input("'" + path.string() + "' is not JSON", "a sensor description like resources/sensors/vlp16.json");
  try {
    auto model = sensor_model_from_json(json, id);
    if (named_file) model.file = path;
    return model;
  } catch (const Error& e) {
    throw e.at(path.string());
  }
}

}  // namespace bole::sensor
